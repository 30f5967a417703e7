// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/error.hpp"

#include <algorithm>
#include <array>

namespace mbncc {
namespace {

struct Entry {
  LearnError error;
  const char* name;
  const char* message;
  const char* hint;
};

constexpr std::array<Entry, 25> kEntries{{
    {LearnError::kSuccess, "SUCCESS", "The object was learned.", "Nothing to do."},
    {LearnError::kNoImage, "NO_IMAGE", "No usable image arrived.",
     "Check the camera and the image topic, or give a readable image of at least 32 x 32 "
     "pixels."},
    {LearnError::kRegionInvalid, "REGION_INVALID", "The region does not lie in the image.",
     "Give a region of at least 8 x 8 pixels inside the image; an outline needs three corners "
     "and must not cross itself."},
    {LearnError::kNoChange, "NO_CHANGE", "The images before and after show no difference.",
     "Take away only the object, and let a region (roi), if one is given, cover the place where "
     "it lay."},
    {LearnError::kChangeTooLarge, "CHANGE_TOO_LARGE",
     "Nearly everything changed between the images.",
     "Keep light, exposure and camera still while the object is taken away, then teach again."},
    {LearnError::kNotStill, "NOT_STILL", "The scene did not come to rest.",
     "Move arm and hands out of the image and wait for the message."},
    {LearnError::kSegmentationEmpty, "SEGMENTATION_EMPTY", "No object stands out in the region.",
     "The region (roi) may cut the object off: draw it larger; or put the object on a background "
     "of another colour."},
    {LearnError::kSegmentationFull, "SEGMENTATION_FULL",
     "The whole region was segmented as object.",
     "The region (roi) may cut the object off: draw it larger, with background on every side."},
    {LearnError::kTouchesBorder, "TOUCHES_BORDER", "The object touches the image's border.",
     "Move the object fully into view and teach again."},
    {LearnError::kTooSmall, "TOO_SMALL", "The object is too small for reliable detection.",
     "Move the camera closer or use a higher resolution."},
    {LearnError::kLowTexture, "LOW_TEXTURE",
     "The object has too little texture and outline to be found.",
     "Turn its marked side up or improve the light."},
    {LearnError::kNotDistinct, "NOT_DISTINCT",
     "The object cannot be distinguished from its surroundings.",
     "Teach it on a plainer background, or turn its marked side up."},
    {LearnError::kAlreadyKnown, "ALREADY_KNOWN", "The library already contains this object.",
     "Replace it (overwrite), or add a view to it (add_view)."},
    {LearnError::kNameInvalid, "NAME_INVALID", "The name is not allowed.",
     "Use a letter, then letters, digits or underscores, 64 characters at most."},
    {LearnError::kNameTaken, "NAME_TAKEN", "The name is in the library already.",
     "Replace it (overwrite), add a view to it (add_view), or choose another name."},
    {LearnError::kStorage, "STORAGE", "The object could not be stored.",
     "Check the library folder's disk space and permissions; the library itself is unchanged."},
    {LearnError::kRejectedByOperator, "REJECTED_BY_OPERATOR", "The operator rejected the lesson.",
     "Teach again when ready; nothing was stored."},
    {LearnError::kCancelled, "CANCELLED", "The lesson was cancelled.",
     "Teach again when ready; nothing was stored."},
    {LearnError::kTimeout, "TIMEOUT", "The lesson ran out of time.",
     "Follow the messages sooner, or give a longer timeout."},
    {LearnError::kEncoding, "ENCODING", "The image's encoding or layout is not supported.",
     "Use mono8, mono16, bgr8, rgb8, bgra8, rgba8, bayer_*8, yuv422 or yuv422_yuy2 with a step and "
     "data length that fit."},
    {LearnError::kBusy, "BUSY", "Another lesson is running.", "Wait for it to end, or cancel it."},
    {LearnError::kNameUnknown, "NAME_UNKNOWN", "The library has no object of this name.",
     "Choose a name of the library, or teach the object as a new one, without add_view."},
    {LearnError::kImageMismatch, "IMAGE_MISMATCH", "The images differ in size.",
     "Teach again without changing the camera's image size; given images and maps must have "
     "the same size."},
    {LearnError::kQualityBad, "QUALITY_BAD", "The lesson is not good enough to store.",
     "Follow the advice, or set allow_bad to store it anyway."},
    {LearnError::kInternal, "INTERNAL", "An unexpected error ended the lesson.",
     "Report the message with the log; nothing was stored."},
}};

const Entry& entry_of(LearnError error) {
  const auto found = std::find_if(kEntries.begin(), kEntries.end(),
                                  [error](const Entry& entry) { return entry.error == error; });
  return found == kEntries.end() ? kEntries.back() : *found;
}

}  // namespace

const char* to_string(LearnError error) {
  return entry_of(error).name;
}
const char* message_of(LearnError error) {
  return entry_of(error).message;
}
const char* hint_of(LearnError error) {
  return entry_of(error).hint;
}

}  // namespace mbncc
