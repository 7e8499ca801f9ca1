package org.mechservice.mechml.document;

import java.util.Optional;
import org.apache.xerces.xni.XNIException;
import org.apache.xerces.xni.parser.XMLErrorHandler;
import org.apache.xerces.xni.parser.XMLParseException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Receives the XML parser's errors. The first error of well-formedness ends the reading. The first
 * error of validity is kept for the case that the grammar check finds nothing.
 */
final class ParserErrors implements XMLErrorHandler {
  /**
   * An error of validity.
   *
   * @param position the parser's position
   * @param text the parser's sentence
   */
  record Invalidity(SourcePosition position, String text) {}

  private final ElementBuilder builder;
  private Optional<Invalidity> invalidity = Optional.empty();
  private int invalidities;

  /**
   * Begins without errors.
   *
   * @param builder knows the innermost open element
   */
  ParserErrors(ElementBuilder builder) {
    this.builder = builder;
  }

  /** Returns the first error of validity. */
  Optional<Invalidity> invalidity() {
    return invalidity;
  }

  /** {@inheritDoc} Ignores the parser's warnings: they concern only the bundled grammar. */
  @Override
  public void warning(String domain, String key, XMLParseException exception) {}

  @Override
  public void error(String domain, String key, XMLParseException exception) {
    invalidities++;
    Invalidity first =
        invalidity.orElseGet(() -> new Invalidity(position(exception), invalid(key, exception)));
    invalidity = Optional.of(first);
    if (invalidities > Limits.INVALIDITIES) {
      throw new XNIException(
          new RejectedFileException(
              MessageCode.INVALID_DOCUMENT,
              first.position(),
              first.text() + "; more than " + Limits.INVALIDITIES + " such faults follow"));
    }
  }

  @Override
  public void fatalError(String domain, String key, XMLParseException exception) {
    MessageCode code =
        switch (key) {
          case "EntityExpansionLimitExceeded" -> MessageCode.MODEL_FILE_TOO_LARGE;
          case "EncodingDeclInvalid",
              "EncodingNotSupported",
              "EncodingByteOrderUnsupported",
              "InvalidByte",
              "ExpectedByte",
              "InvalidHighSurrogate",
              "InvalidASCII",
              "CharConversionFailure" ->
              MessageCode.UNREADABLE_TEXT;
          default -> MessageCode.NOT_WELL_FORMED;
        };
    throw new XNIException(
        new RejectedFileException(code, position(exception), notWellFormed(key, exception)));
  }

  private static SourcePosition position(XMLParseException exception) {
    return new SourcePosition(
        Math.max(0, exception.getLineNumber()), Math.max(0, exception.getColumnNumber()), "");
  }

  private String invalid(String key, XMLParseException exception) {
    return key.startsWith("MSG_CONTENT_IN")
        ? innermost(" has content between its tags, possibly only a blank; it must be empty")
        : ParserMessages.of(key, String.valueOf(exception.getMessage()));
  }

  private String notWellFormed(String key, XMLParseException exception) {
    return switch (key) {
      case "ETagRequired" -> innermost(" is not closed; write its end tag before this one");
      case "MarkupEntityMismatch" -> innermost(" is not closed before the end of the file");
      default -> ParserMessages.of(key, String.valueOf(exception.getMessage()));
    };
  }

  private String innermost(String predicate) {
    return builder
        .innermost()
        .map(e -> Phrase.of("<%s> of line %d%s", e.name(), e.position().line(), predicate))
        .orElse("the outermost element" + predicate);
  }
}
