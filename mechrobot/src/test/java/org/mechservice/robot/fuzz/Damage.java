package org.mechservice.robot.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Random damage to the bytes of a file. */
final class Damage {
  /** Words that mean something somewhere in a file, or should not. */
  private static final List<String> WORDS =
      List.of(
          "<",
          ">",
          "/>",
          "</",
          "\"",
          "'",
          "&",
          "&amp;",
          "&#0;",
          "&#x10FFFF;",
          "&x;",
          "<!--",
          "-->",
          "<![CDATA[",
          "]]>",
          "<?x?>",
          "<!DOCTYPE MechML>",
          "<!ENTITY x SYSTEM \"file:///etc/passwd\">",
          "\u0000",
          "\uFFFE",
          "\uFEFF",
          "\uD83D\uDE00",
          "\r",
          "\r\n",
          "1e999",
          "NaN",
          "Infinity",
          "-1",
          "1/0",
          "(((",
          "1e-320",
          "unit=\"deg\"",
          "unit=\"kg\"",
          "type=\"F\"",
          "vector2=\"u1\"",
          "name=\"\"",
          "name=\"Ground\"",
          "<body/>",
          "<joint/>",
          ";",
          "PI",
          "^^",
          "sqrt(",
          "0^0",
          "-1^0.5",
          "t",
          "j1.q",
          "j1.v[9]",
          "'a b'.q",
          "Ground.p1.x",
          "s",
          "1e5000000000",
          "1;2;3",
          "evil.Evil.class",
          "java.lang.Runtime",
          "../../evil.class",
          "http://localhost/x.dtd",
          "9".repeat(400),
          "a".repeat(3000),
          "(".repeat(500));

  private static final List<String> CHARSETS =
      List.of("UTF-16", "UTF-16LE", "UTF-16BE", "ISO-8859-1", "US-ASCII", "UTF-32");

  private final Random random;

  Damage(Random random) {
    this.random = random;
  }

  /** Returns the file, damaged in one to four places. */
  byte[] to(byte[] original) {
    byte[] content = original;
    for (int k = random.nextInt(1, 5); k > 0; k--) {
      content = once(content);
    }
    return content;
  }

  private byte[] once(byte[] content) {
    int from = random.nextInt(content.length + 1);
    int to = Math.min(content.length, from + random.nextInt(60));
    return switch (random.nextInt(12)) {
      case 0 -> spliced(content, from, to, new byte[0]);
      case 1 -> spliced(content, from, from, Arrays.copyOfRange(content, from, to));
      case 2 -> spliced(content, from, Math.min(content.length, from + 1), someByte());
      case 3 -> spliced(content, from, from, word());
      case 4 -> random.nextInt(20) == 0 ? recoded(content) : valueReplaced(content, from);
      case 5 -> elementMoved(content, from);
      default -> valueReplaced(content, from);
    };
  }

  private byte[] someByte() {
    return new byte[] {(byte) random.nextInt(256)};
  }

  private byte[] word() {
    return WORDS.get(random.nextInt(WORDS.size())).getBytes(StandardCharsets.UTF_8);
  }

  private byte[] recoded(byte[] content) {
    String charset = CHARSETS.get(random.nextInt(CHARSETS.size()));
    return new String(content, StandardCharsets.UTF_8)
        .getBytes(java.nio.charset.Charset.forName(charset));
  }

  /** Replaces the next attribute's value by a word or by another value of the file. */
  private byte[] valueReplaced(byte[] content, int from) {
    int[] value = value(content, from);
    int[] other = value(content, random.nextInt(content.length + 1));
    if (value.length == 0) {
      return content;
    }
    byte[] by =
        other.length == 0 || random.nextBoolean()
            ? word()
            : Arrays.copyOfRange(content, other[0], other[1]);
    return spliced(content, value[0], value[1], by);
  }

  private static int[] value(byte[] content, int from) {
    String text = new String(content, StandardCharsets.ISO_8859_1);
    int open = text.indexOf('"', from);
    int close = text.indexOf('"', open + 1);
    return open < 0 || close < 0 ? new int[0] : new int[] {open + 1, close};
  }

  /** Puts the next empty element in another place. */
  private byte[] elementMoved(byte[] content, int from) {
    String text = new String(content, StandardCharsets.ISO_8859_1);
    int open = text.indexOf('<', from);
    int close = text.indexOf("/>", from);
    int target = text.indexOf('<', random.nextInt(content.length + 1));
    if (open < 0 || close < open || target < 0) {
      return content;
    }
    byte[] element = Arrays.copyOfRange(content, open, close + 2);
    return spliced(content, target, target, element);
  }

  private static byte[] spliced(byte[] content, int from, int to, byte[] inserted) {
    byte[] result = new byte[content.length - (to - from) + inserted.length];
    System.arraycopy(content, 0, result, 0, from);
    System.arraycopy(inserted, 0, result, from, inserted.length);
    System.arraycopy(content, to, result, from + inserted.length, content.length - to);
    return result;
  }
}
