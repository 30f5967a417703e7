// SPDX-License-Identifier: BSD-3-Clause
// The console's ROS interface: receives topics and calls services on its own threads, and passes
// results to the window's thread as queued signals.
#pragma once

#ifndef Q_MOC_RUN
#include <actionlib_msgs/GoalStatusArray.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Config.h>
#include <mbncc_vision/ConfirmLearning.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/ExplainPlace.h>
#include <mbncc_vision/LearnObjectActionFeedback.h>
#include <mbncc_vision/LearnObjectActionResult.h>
#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnedObject.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include "console/cell_settings.hpp"
#include "console/image/image_origin.hpp"
#include "console/image/images.hpp"
#include "console/service_calls.hpp"
#endif

#include <QImage>
#include <QObject>
#include <QPointF>
#include <QRect>
#include <QString>
#include <atomic>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

namespace mbncc::console {

/// Names of the cell's nodelets; relative names resolve in the namespace of RViz.
struct Names {
  std::string cell;                   ///< namespace of the cell; "": that of the console
  std::string matching = "matching";  ///< name of the matching nodelet, for its private names
};

class RosLink : public QObject {
  Q_OBJECT

 public:
  RosLink();
  ~RosLink() override;

  void connect_to(const Names& names);

  /// Namespace of the cell, as ROS resolves it.
  std::string cell() const { return node_.getNamespace(); }

  /// Returns the id of the goal that was sent.
  std::string teach(const mbncc_vision::LearnObjectGoal& goal);
  void cancel(const std::string& goal);

  // These return at once; a signal delivers the answer.
  void confirm(const mbncc_vision::ConfirmLearning::Request& request);
  void edit(const mbncc_vision::EditObject::Request& request);
  void mark_grasp();
  /// Why grasps cannot be marked in this cell; "" if they can. Queries the parameter server.
  std::string why_no_grasps() const;
  void list_objects();
  /// Explains why objects are found at `place` [px] in the newest image or not.
  void explain(QPointF place);
  /// Finds all detections in the newest image with minimal thresholds.
  void find_all();
  /// Reads the matching nodelet's thresholds from the parameter server.
  Thresholds thresholds() const;
  void set_thresholds(const Thresholds& thresholds);
  /// Limits the search to `region` [px]; an empty one: the whole image.
  void set_search_region(const QRect& region);
  /// Sends a calibration to the camera.
  void keep_calibration(const sensor_msgs::CameraInfo& calibration);
  /// The source of the cell's images. Queries the parameter server.
  CellImages images() const;
  /// Saves the last explanation in a file.
  void save_explained();
  /// Aborts a call to the learning nodelet that waits for an answer; it fails.
  void give_up_teaching();

  /// Tints live images where they differ from the first image that arrives after this call.
  void show_changes(bool wanted) { changes_wanted_ = wanted; }

 Q_SIGNALS:
  void status_heard(actionlib_msgs::GoalStatusArray status);
  void feedback_heard(mbncc_vision::LearnObjectActionFeedback feedback);
  void result_heard(mbncc_vision::LearnObjectActionResult result);
  void draft_heard(mbncc_vision::LearnObjectResult draft);
  void detections_heard(mbncc_vision::DetectedObjectArray detections, double age);
  void diagnostics_heard(diagnostic_msgs::DiagnosticArray diagnostics);
  /// An image of the camera, possibly scaled down, and its original size [px].
  void image_heard(QImage image, QSize size);
  /// `warning`: why the camera's images are not live; "" if they are. Emitted before each
  /// image_heard().
  void origin_heard(QString warning);
  /// The same for an image with `detections`.
  void searched_heard(QImage image, QSize size, mbncc_vision::DetectedObjectArray detections);
  /// The learning image of the lesson's draft.
  void lesson_image_heard(QImage image);
  void score_map_heard(QImage image);
  /// `folder` of the library on the nodelet's computer, and its number there.
  void objects_listed(std::vector<mbncc_vision::LearnedObject> objects, QString folder,
                      quint64 inode);
  void confirmed(bool answered, bool success, QString message);
  /// `settled`: carried out, or it would be refused again; false: it can be repeated.
  void edited(mbncc_vision::EditObject::Request request, bool settled, bool success,
              QString message);
  void grasp_marked(bool success, QString message);
  /// `image`: the image with the explanation drawn into it.
  void explained(bool success, QString lines, QImage image);
  void explained_saved(QString file);
  void calibration_kept(bool success, QString message);
  void all_found(bool success, QString message, QImage image, QSize size,
                 mbncc_vision::DetectedObjectArray detections);
  void thresholds_set(bool success, QString message);
  /// `region` [px] that is searched; empty: the whole image. Emitted on connecting and after every
  /// change.
  void search_region_heard(QRect region);
  void search_region_set(bool success, QString message);

 private:
  void subscribe_lesson(ros::NodeHandle& node);
  void subscribe_cell(ros::NodeHandle& node);
  void subscribe_settings(ros::NodeHandle& node);
  /// The topic that a parameter of cell.launch names, unless image_raw is remapped.
  std::string image_topic(const std::string& parameter) const;
  /// Subscribes to the searched images, even if the cell starts later than the console.
  void follow_images();
  void take_image(const sensor_msgs::ImageConstPtr& message);
  /// A camera's image with the brightness that the matching nodelet uses.
  cv::Mat live_rgb(const sensor_msgs::Image& message) const;
  sensor_msgs::ImageConstPtr shown();
  void note_shown(const sensor_msgs::ImageConstPtr& message);
  void take_detections(const mbncc_vision::DetectedObjectArray& detections);

  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  std::vector<ros::Subscriber> subscribers_;
  ros::Subscriber images_;  // used only by the spinner's thread once that runs
  ros::Publisher goal_publisher_, cancel_publisher_;
  ros::NodeHandle node_;
  int goals_ = 0;
  std::atomic<bool> changes_wanted_{false};
  ImageOrigin origin_;                             // used only by the spinner's thread
  ChangeTint tint_;                                // used only by the spinner's thread
  std::deque<sensor_msgs::ImageConstPtr> newest_;  // in order; used only by the spinner's thread
  std::mutex shown_mutex_;
  sensor_msgs::ImageConstPtr shown_;               // the newest one delivered
  mbncc_vision::ExplainPlace::Request explained_;  // used only by the thread of search_calls_
  std::string learning_ = "learning", matching_;
  // One for each nodelet, so that one that hangs delays no call to another. Last, so that no
  // function runs while the rest is being destroyed.
  ServiceCalls teaching_calls_, search_calls_, camera_calls_;
};

}  // namespace mbncc::console
