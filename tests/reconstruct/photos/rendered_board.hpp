#pragma once
/// Photos of a flat drawing from a ring of cameras, with noise; OpenCV draws boards and markers.
#include <opencv2/core/version.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/random.hpp"
#include "reconstruct/photos/charuco_board.hpp"
#include "reconstruct/photos/detail/marker_corners.hpp"
#include "tests/support/scratch_folder.hpp"

#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407
#include <opencv2/objdetect/charuco_detector.hpp>
#else
#include <opencv2/aruco/charuco.hpp>
#endif

namespace clast {

/// Pixels of a drawing for a metre of it.
inline constexpr double kDrawingPixels = 4000.0;

/// The board at `kDrawingPixels`, with a white margin of 2 cm.
inline cv::Mat drawn_board(const CharucoBoard& board) {
  const int margin = static_cast<int>(0.02 * kDrawingPixels);
  const cv::Size size(static_cast<int>(board.columns * board.square * kDrawingPixels) + 2 * margin,
                      static_cast<int>(board.rows * board.square * kDrawingPixels) + 2 * margin);
  const auto dictionary =
      cv::aruco::getPredefinedDictionary(photos_detail::opencv_dictionary(board.dictionary));
  const auto square = static_cast<float>(board.square), marker = static_cast<float>(board.marker);
  cv::Mat drawing;
#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407
  const cv::aruco::CharucoBoard printed({board.columns, board.rows}, square, marker, dictionary);
  printed.generateImage(size, drawing, margin);
#else
  cv::aruco::CharucoBoard::create(board.columns, board.rows, square, marker, dictionary)
      ->draw(size, drawing, margin);
#endif
  return drawing;
}

/// Markers of a side on white, ids from 0, each with its middle at the place given, m.
inline cv::Mat drawn_markers(const std::string& dictionary, double side,
                             const std::vector<Vec2>& centres, double width, double height) {
  cv::Mat drawing(static_cast<int>(height * kDrawingPixels),
                  static_cast<int>(width * kDrawingPixels), CV_8UC1, cv::Scalar(255));
  const auto known =
      cv::aruco::getPredefinedDictionary(photos_detail::opencv_dictionary(dictionary));
  const int pixels = static_cast<int>(side * kDrawingPixels);
  for (std::size_t id = 0; id < centres.size(); ++id) {
    cv::Mat marker;
#if CV_VERSION_MAJOR * 100 + CV_VERSION_MINOR >= 407
    cv::aruco::generateImageMarker(known, static_cast<int>(id), pixels, marker);
#else
    cv::aruco::drawMarker(known, static_cast<int>(id), pixels, marker);
#endif
    const Vec2 corner = kDrawingPixels * (centres[id] - Vec2(side / 2, side / 2));
    marker.copyTo(drawing(cv::Rect(static_cast<int>(std::lround(corner.x())),
                                   static_cast<int>(std::lround(corner.y())), pixels, pixels)));
  }
  return drawing;
}

/// Six photos of the drawing, which lies in the plane z = 0 of a model whose unit is `unit`
/// metres, x to the right of the drawing and y down from its upper left corner.
inline PhotoModel photographed(const cv::Mat& drawing, double unit, const ScratchFolder& folder) {
  constexpr int kWidth = 1600, kHeight = 1200, kFiner = 3;
  PhotoModel model;
  model.lenses.push_back({.width = kWidth,
                          .height = kHeight,
                          .fx = 1500.0,
                          .fy = 1500.0,
                          .cx = 0.5 * kWidth - 0.5,
                          .cy = 0.5 * kHeight - 0.5});
  const CameraIntrinsics& lens = model.lenses[0];
  const Vec3 middle(0.5 * drawing.cols / kDrawingPixels, 0.5 * drawing.rows / kDrawingPixels, 0.0);
  const double reach = 1.9 * std::max(middle.x(), middle.y());
  Random random(5);
  for (int i = 0; i < 6; ++i) {
    // z points into the drawing: cameras are at negative z.
    const double azimuth = 2.0 * kPi * i / 6, height = 0.7 + 0.1 * (i % 3);
    const Vec3 eye = middle + 2.4 * reach *
                                  Vec3(std::cos(azimuth) * std::cos(height),
                                       std::sin(azimuth) * std::cos(height), -std::sin(height));
    const Vec3 ahead = (middle - eye).normalized(),
               right = Vec3(0.1, 1.0, 0.0).cross(ahead).normalized();
    Mat3 turn;
    turn << right.transpose(), ahead.cross(right).transpose(), ahead.transpose();
    // From pixels of the drawing to pixels of a finer photo: centres of pixels are whole numbers.
    Mat3 plane;
    plane << turn.col(0), turn.col(1), -turn * eye;
    Mat3 camera = Mat3::Identity();
    camera << kFiner * lens.fx, 0, kFiner * (lens.cx + 0.5) - 0.5, 0, kFiner * lens.fy,
        kFiner * (lens.cy + 0.5) - 0.5, 0, 0, 1;
    Mat3 metres = Mat3::Identity();
    metres << 1.0 / kDrawingPixels, 0, 0.5 / kDrawingPixels, 0, 1.0 / kDrawingPixels,
        0.5 / kDrawingPixels, 0, 0, 1;
    const Mat3 to_photo = camera * plane * metres;
    cv::Mat homography(3, 3, CV_64F);
    for (int k = 0; k < 9; ++k) homography.at<double>(k / 3, k % 3) = to_photo(k / 3, k % 3);
    cv::Mat fine, photo;
    cv::warpPerspective(drawing, fine, homography, {kFiner * kWidth, kFiner * kHeight},
                        cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(140));
    cv::resize(fine, photo, {kWidth, kHeight}, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(photo, photo, {0, 0}, 0.6);
    for (int y = 0; y < photo.rows; ++y) {
      for (int x = 0; x < photo.cols; ++x) {
        const double grey = 0.85 * photo.at<unsigned char>(y, x) + 20.0 + 1.5 * random.normal();
        photo.at<unsigned char>(y, x) = cv::saturate_cast<unsigned char>(grey);
      }
    }
    const std::string name = "p" + std::to_string(i) + ".png";
    cv::imwrite((folder / name).string(), photo);
    const Pose pose{-turn * eye / unit, Quat(turn)};
    model.photos.push_back({name, folder / name, 0, pose});
  }
  return model;
}

}  // namespace clast
