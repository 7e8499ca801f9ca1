package org.mechservice.sim.user;

import java.util.regex.Pattern;

/**
 * A file that came with a model: source or class file of a class.
 *
 * @param name its path below the model's folder, such as {@code car/Road.java}
 * @param content its bytes; not modified
 */
@SuppressWarnings("ArrayRecordComponent") // never compared; unchanged bytes
public record UserFile(String name, byte[] content) {
  private static final Pattern USABLE =
      Pattern.compile("(?:[A-Za-z0-9_$]{1,100}/){0,20}[A-Za-z0-9_$]{1,200}\\.(?:class|java)");

  /** Returns whether the content may be of the kind that its name states. */
  boolean isUsable() {
    return USABLE.matcher(name).matches();
  }

  boolean isSource() {
    return name.endsWith(".java");
  }
}
