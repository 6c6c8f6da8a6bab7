// SPDX-License-Identifier: MIT
// FFmpeg's libraries, loaded when one of their functions is first called: they take longer to load
// than the rest of the program, and most commands make no movie.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/crc.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

// library, function
#define HACKLE_FFMPEG_FUNCTIONS(X)            \
  X(avformat, av_interleaved_write_frame)     \
  X(avformat, av_read_frame)                  \
  X(avformat, av_write_trailer)               \
  X(avformat, avformat_alloc_output_context2) \
  X(avformat, avformat_close_input)           \
  X(avformat, avformat_find_stream_info)      \
  X(avformat, avformat_free_context)          \
  X(avformat, avformat_new_stream)            \
  X(avformat, avformat_open_input)            \
  X(avformat, avformat_write_header)          \
  X(avformat, avio_closep)                    \
  X(avformat, avio_open)                      \
  X(avformat, avio_write)                     \
  X(avcodec, av_packet_alloc)                 \
  X(avcodec, av_packet_free)                  \
  X(avcodec, av_packet_rescale_ts)            \
  X(avcodec, av_packet_unref)                 \
  X(avcodec, avcodec_alloc_context3)          \
  X(avcodec, avcodec_find_encoder_by_name)    \
  X(avcodec, avcodec_free_context)            \
  X(avcodec, avcodec_open2)                   \
  X(avcodec, avcodec_parameters_copy)         \
  X(avcodec, avcodec_parameters_from_context) \
  X(avcodec, avcodec_receive_packet)          \
  X(avcodec, avcodec_send_frame)              \
  X(swscale, sws_freeContext)                 \
  X(swscale, sws_getContext)                  \
  X(swscale, sws_scale)                       \
  X(avutil, av_crc)                           \
  X(avutil, av_crc_get_table)                 \
  X(avutil, av_d2q)                           \
  X(avutil, av_dict_copy)                     \
  X(avutil, av_dict_free)                     \
  X(avutil, av_dict_get)                      \
  X(avutil, av_dict_parse_string)             \
  X(avutil, av_dict_set)                      \
  X(avutil, av_dict_set_int)                  \
  X(avutil, av_frame_alloc)                   \
  X(avutil, av_frame_free)                    \
  X(avutil, av_frame_get_buffer)              \
  X(avutil, av_frame_make_writable)           \
  X(avutil, av_get_pix_fmt)                   \
  X(avutil, av_log_set_level)                 \
  X(avutil, av_pix_fmt_desc_get)              \
  X(avutil, av_rescale_q)                     \
  X(avutil, av_strerror)

namespace hackle::av {

struct Functions {
// A declared name takes no parentheses. NOLINTNEXTLINE(bugprone-macro-parentheses)
#define HACKLE_FFMPEG_MEMBER(library, name) decltype(&::name) name = nullptr;
  HACKLE_FFMPEG_FUNCTIONS(HACKLE_FFMPEG_MEMBER)
#undef HACKLE_FFMPEG_MEMBER
};

// Throws Error (run_failed) if a library is not installed, or differs from the one Hackle was built
// with.
const Functions& ffmpeg();

}  // namespace hackle::av
