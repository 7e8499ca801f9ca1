package org.mechservice.mechml.document;

import org.mechservice.mechml.diagnosis.SourcePosition;
import org.xml.sax.Locator;
import org.xml.sax.helpers.LocatorImpl;

/** The parser's current position. */
final class ParserPosition {
  private Locator locator = new LocatorImpl();

  /** Uses the parser's locator, which the parser updates as it reads. */
  void follow(Locator parserLocator) {
    this.locator = parserLocator;
  }

  int line() {
    return Math.max(0, locator.getLineNumber());
  }

  int column() {
    return Math.max(0, locator.getColumnNumber());
  }

  /** Returns the position, without an element's path. */
  SourcePosition position() {
    return new SourcePosition(line(), column(), "");
  }
}
