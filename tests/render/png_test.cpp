// SPDX-License-Identifier: MIT
#include "render/png.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace {

TEST(Png, ComesBackAsItWasWritten) {
  Image image(3, 2);
  for (std::size_t k = 0; k < image.pixels.size(); ++k)
    image.pixels[k] = k % 4 == 3 ? 255 : static_cast<std::uint8_t>(10 * k);
  const auto path = test::fresh_folder() / "a.png";
  write_png(image, path);
  cairo_surface_t* read = cairo_image_surface_create_from_png(path.c_str());
  ASSERT_EQ(cairo_surface_status(read), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(cairo_image_surface_get_width(read), 3);
  EXPECT_EQ(cairo_image_surface_get_height(read), 2);
  const unsigned char* data = cairo_image_surface_get_data(read);
  const int stride = cairo_image_surface_get_stride(read);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(data[y * stride + 4 * x + c],
                  image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x + c)]);
  cairo_surface_destroy(read);
}

TEST(Png, AFolderThatIsNotThereIsAnError) {
  EXPECT_THROW(write_png(Image(2, 2), test::fresh_folder() / "no" / "a.png"), Error);
}

TEST(Png, AnInterruptLeavesNoFile) {
  const auto folder = test::fresh_folder();
  request_interrupt();
  try {
    write_png(Image(200, 200), folder / "a.png");
    ADD_FAILURE() << "it was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
  clear_interrupt();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace hackle
