package org.mechservice.mechml.document;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Place;

/** Where a file stops being UTF-8: the XML parser, which reads ahead, does not tell. */
final class FirstBadByte {
  private FirstBadByte() {}

  /** Returns the place of the first byte that is not UTF-8; empty if all are. */
  static Optional<Place> place(byte[] content) {
    ByteBuffer bytes = ByteBuffer.wrap(content);
    CharBuffer text = CharBuffer.allocate(content.length);
    CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(bytes, text, true);
    if (!result.isError()) {
      return Optional.empty();
    }
    String before = text.flip().toString();
    int line = 1 + (int) before.chars().filter(c -> c == '\n').count();
    int column = before.length() - before.lastIndexOf('\n');
    return Optional.of(new Place(line, column, ""));
  }
}
