// SPDX-License-Identifier: BSD-3-Clause
// The console in its own window, without RViz.
#include <ros/ros.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QMainWindow>
#include <QRegularExpression>
#include <QScreen>
#include <QTimer>

#include "console/console_widget.hpp"
#include "console/widgets.hpp"

namespace {

constexpr int kGlance = 200;  // [ms] between checks whether ROS is shutting down

}  // namespace

int main(int argc, char** argv) {
  // A second node of the same name would end the first one.
  ros::init(argc, argv, "console",
            ros::init_options::NoSigintHandler | ros::init_options::AnonymousName);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argc, argv);
  QApplication::setApplicationName("mbncc console");
  QCommandLineParser words;
  words.setApplicationDescription("The operator's console of a cell.");
  words.addHelpOption();
  words.addOptions({{"cell", "namespace of the cell", "NAMESPACE", ""},
                    {"matching", "private namespace of the matching nodelet", "NAME", "matching"}});
  words.process(QStringList(application.arguments().filter(QRegularExpression("^(?!__|.*:=)"))));

  ros::NodeHandle keeps_the_node_running;
  QMainWindow window;
  window.setWindowTitle("mbncc console");
  // On a screen that is too small, the window scrolls, so that all buttons stay reachable.
  auto* area = mbncc::console::make_scroll_area(new mbncc::console::ConsoleWidget(
      {words.value("cell").toStdString(), words.value("matching").toStdString()}));
  area->setFocusPolicy(Qt::NoFocus);
  window.setCentralWidget(area);
  // For systems without a window manager that maximizes the window.
  window.setGeometry(QGuiApplication::primaryScreen()->availableGeometry());
  window.showMaximized();
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, [] {
    if (!ros::ok()) QApplication::quit();
  });
  watch.start(kGlance);
  return QApplication::exec();
}
