// SPDX-License-Identifier: BSD-3-Clause
// Everything about an object that does not depend on the image searched.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "matching/evidence/colour_parts.hpp"
#include "matching/evidence/interior_edges.hpp"
#include "matching/evidence/mirrored_contour.hpp"
#include "matching/evidence/outline_contrast.hpp"
#include "matching/evidence/print_comparison.hpp"
#include "matching/evidence/ratio_residual.hpp"
#include "matching/proposal/colour_prefilter.hpp"
#include "matching/proposal/contour_bank.hpp"
#include "matching/proposal/template_bank.hpp"
#include "matching/refinement/refinement.hpp"
#include "matching/template/view_frame.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/polar_search.hpp"
#include "mbncc/matching/similarity.hpp"
#include "mbncc/object_model.hpp"
#include "numeric/lazy.hpp"

namespace mbncc::prepared {

/// Search engine for poses.
enum class Engine { kFast, kPolar };

/// The engine named by SearchConfig::engine.
inline Engine engine_of(const SearchConfig& config) {
  return config.engine == "polar" ? Engine::kPolar : Engine::kFast;
}

/// An object in two sizes other than the learned one.
struct ResizedTemplates {
  double scale;                     ///< scale of `near`, which heights and tilts can cause
  templates::PoseTemplate near;     ///< at `scale`
  templates::PoseTemplate farther;  ///< twice as far from the learned size
};

/// One view, with the templates that the searches need.
class PreparedView : public templates::ViewFrame {
 public:
  /// Prepares the view for objects that appear `scale` times as large as learned.
  PreparedView(const View& view, Engine engine, double scale = 1);

  int top_level() const { return static_cast<int>(tracked.size()) - 1; }

  cv::Point2d anchor;  ///< [px] in the view's crop
  templates::MapGeometry geometry;
  proposal::ColourPrefilter colour_prefilter;
  proposal::TemplateBank template_bank;
  proposal::ContourBank contour_bank;
  std::vector<templates::PoseTemplate>
      rough;  ///< per level: for pruning the coarse searches' candidates
  std::vector<templates::PoseTemplate> tracked;  ///< per level, small, for dozens of candidates
  templates::PoseTemplate fine;                ///< at full resolution, for the last few candidates
  evidence::RatioResidual ratios;              ///< of `fine`
  std::array<ResizedTemplates, 2> resized;     ///< `fine`, smaller and larger
  evidence::MirroredContour mirrored_contour;  ///< of the contour of `fine`
  evidence::ColourParts parts;                 ///< of `fine`
  evidence::OutlineContrast outline_contrast;  ///< of the contour of `fine`
  evidence::InteriorEdges interior_edges;      ///< at full resolution
  evidence::PrintComparison print;             ///< at full resolution
  refinement::RefinementTemplate dense;        ///< at full resolution, for sub-pixel refinement
  MaskedTemplate points;                       ///< all map pixels at full resolution
  std::optional<PolarSearch> polar;            ///< with Engine::kPolar

 private:
  struct Source;
  PreparedView(const Source& source, Engine engine);
  void prepare_verification(const cv::Mat& map, const scene::SceneLevel& lesson);
};

struct PreparedObject {
  /// Every view at every scale in [1 - scale_range, 1 + scale_range] that has to be searched. The
  /// views are grey unless all of them show colour.
  PreparedObject(std::shared_ptr<const ObjectModel> object, Engine engine, double scale_range = 0);

  int top_level() const;

  /// Least width and height [px] of an image in which the object can be searched for.
  int least_image() const;

  /// Rotates all templates now instead of in the first search that needs them.
  void make_rotations() const;

  std::shared_ptr<const ObjectModel> model;
  bool coloured;  ///< the views show colour
  std::vector<PreparedView> views;
  /// The object in grey, for grey images; null if the views are grey.
  numeric::Lazy<std::shared_ptr<const PreparedObject>> in_grey;

 private:
  PreparedObject(std::shared_ptr<const ObjectModel> object, Engine engine, double scale_range,
                 bool coloured);
};

}  // namespace mbncc::prepared
