package org.mechservice.view.web;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.orb.http.Request;

/**
 * A file for a user.
 *
 * @param type media type
 * @param content its bytes, unless they are in a file
 * @param file where they are, if they are in a file
 */
@SuppressWarnings("ArrayRecordComponent") // made once, written once, never compared
record Download(String type, byte[] content, Optional<Path> file) {
  static Download of(String type, byte[] content) {
    return new Download(type, content, Optional.empty());
  }

  static Download of(String type, Path file) {
    return new Download(type, new byte[0], Optional.of(file));
  }

  void to(Request request) throws IOException {
    if (file.isPresent()) {
      request.answer(type, file.get());
    } else {
      request.answer(200, type, content);
    }
  }
}
