package org.mechservice.mechml.document;

import org.mechservice.mechml.diagnosis.Place;
import org.xml.sax.Locator;
import org.xml.sax.helpers.LocatorImpl;

/** Where the parser stands. */
final class ParserPlace {
  private Locator locator = new LocatorImpl();

  /** Takes the parser's locator, which moves with it. */
  void follow(Locator parserLocator) {
    this.locator = parserLocator;
  }

  int line() {
    return Math.max(0, locator.getLineNumber());
  }

  int column() {
    return Math.max(0, locator.getColumnNumber());
  }

  /** Returns the place, without an element's path. */
  Place place() {
    return new Place(line(), column(), "");
  }
}
