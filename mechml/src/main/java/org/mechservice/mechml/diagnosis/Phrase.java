package org.mechservice.mechml.diagnosis;

import java.util.Locale;

/** Formats the text of messages independently of the machine's language. */
public final class Phrase {
  private Phrase() {}

  /** Returns a format filled in, as {@link String#format} does, with a decimal point. */
  public static String of(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
