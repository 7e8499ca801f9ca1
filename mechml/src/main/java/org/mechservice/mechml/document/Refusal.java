package org.mechservice.mechml.document;

import org.mechservice.mechml.diagnosis.Place;
import org.mechservice.solver.catalogue.MessageCode;
import org.xml.sax.SAXException;

/** A file is not read further. */
final class Refusal extends SAXException {
  private static final long serialVersionUID = 1L;

  private final MessageCode code;
  private final transient Place place;

  Refusal(MessageCode code, Place place, String message) {
    super(message);
    this.code = code;
    this.place = place;
  }

  MessageCode code() {
    return code;
  }

  Place place() {
    return place;
  }

  String text() {
    return String.valueOf(getMessage());
  }
}
