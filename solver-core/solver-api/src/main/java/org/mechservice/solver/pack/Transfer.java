package org.mechservice.solver.pack;

import java.io.IOException;

/**
 * Carries the numbers of a class file over, one by one in the file's order: into symbols or out of
 * them. Each method returns the number it carried, so that one walk through the format serves both
 * ways.
 */
interface Transfer {
  /** Carries one byte. */
  int byteOf(int band) throws IOException;

  /** Carries a number of two bytes that is small as a rule. */
  int small(int band) throws IOException;

  /** Carries a number of two bytes. */
  int pair(int band) throws IOException;

  /** Carries a signed number of two bytes. */
  int signed(int band) throws IOException;

  /** Carries a number of four bytes. */
  int wide(int band) throws IOException;

  /** Carries the index of a constant of a kind, or 0 for none, and returns the constant's text. */
  String reference(int band, int tag) throws IOException;

  /** Carries the name and type of a field or method of the class's own. */
  void member(int band, int tag) throws IOException;

  /** Carries the index of a constant of any kind that can be loaded, in one byte or two. */
  void loadable(int band, int bytes) throws IOException;

  /** Carries zero bytes up to a multiple of four from a start. */
  void align(int start) throws IOException;

  /** Returns how far the class file is carried. */
  int position();

  /** Begins a stretch whose length stands before it in four bytes. */
  int beginLength() throws IOException;

  /** Carries whether the code ends here, the length of which was begun last. */
  boolean codeEnds() throws IOException;

  /** Ends a stretch. */
  void endLength(int begin) throws IOException;
}
