package org.mechservice.cli.shell;

import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Writes text without control sequences of terminals: names and messages come from models, user
 * classes and servers. Control characters, also those that turn the direction of writing, become
 * question marks, but for ends of lines, tabs and the colours of the help.
 */
public final class SafeWriter extends PrintWriter {
  private static final Pattern COLOUR_OR_CONTROL =
      Pattern.compile(
          "\u001b\\[[0-9;]{0,20}m|\r\n"
              + "|[\\x00-\\x08\\x0B-\\x1F\\x7F-\\x9F\u202A-\u202E\u2066-\u2069]");

  /**
   * @param stream receives the text in UTF-8
   */
  public SafeWriter(OutputStream stream) {
    super(stream, true, StandardCharsets.UTF_8);
  }

  @Override
  public void write(String text, int start, int length) {
    String safe = safe(text.substring(start, start + length));
    super.write(safe, 0, safe.length());
  }

  @Override
  public void write(char[] text, int start, int length) {
    write(new String(text, start, length), 0, length);
  }

  @Override
  public void write(int character) {
    write(String.valueOf((char) character), 0, 1);
  }

  private static String safe(String text) {
    Matcher found = COLOUR_OR_CONTROL.matcher(text);
    return found.replaceAll(match -> match.group().length() > 1 ? match.group() : "?");
  }

  /** Returns text without colours, with question marks in place of control sequences. */
  static String withoutColours(String text) {
    return safe(text.replace('\u001b', '?'));
  }
}
