package org.mechservice.mechml.document;

import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.solver.catalogue.MessageCode;
import org.xml.sax.SAXException;

/** Ends the reading of a file at an error that cannot be skipped. */
final class RejectedFileException extends SAXException {
  private static final long serialVersionUID = 1L;

  private final MessageCode code;
  private final transient SourcePosition position;

  RejectedFileException(MessageCode code, SourcePosition position, String message) {
    super(message);
    this.code = code;
    this.position = position;
  }

  MessageCode code() {
    return code;
  }

  SourcePosition position() {
    return position;
  }

  String text() {
    return String.valueOf(getMessage());
  }
}
