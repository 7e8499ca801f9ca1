package org.mechservice.mechml.document;

import java.util.Optional;
import org.apache.xerces.xni.XNIException;
import org.apache.xerces.xni.parser.XMLErrorHandler;
import org.apache.xerces.xni.parser.XMLParseException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Takes the XML parser's complaints: the first about well-formedness ends the reading, the first
 * about validity is kept in case the grammar check cannot explain it.
 */
final class ParserErrors implements XMLErrorHandler {
  /**
   * A complaint about validity.
   *
   * @param position where the parser stood
   * @param text the parser's sentence
   */
  record Invalidity(SourcePosition position, String text) {}

  private final ElementBuilder builder;
  private Optional<Invalidity> invalidity = Optional.empty();
  private int invalidities;

  /**
   * Begins without complaints.
   *
   * @param builder knows which element is open
   */
  ParserErrors(ElementBuilder builder) {
    this.builder = builder;
  }

  /** Returns the first complaint about validity. */
  Optional<Invalidity> invalidity() {
    return invalidity;
  }

  /** {@inheritDoc} The parser's warnings are about grammars, which are ours. */
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
        ? innermost(" has something between its tags, if only a blank; it must be empty")
        : ParserMessages.of(key, String.valueOf(exception.getMessage()));
  }

  private String notWellFormed(String key, XMLParseException exception) {
    return switch (key) {
      case "ETagRequired" -> innermost(" is still open here; its end tag must come first");
      case "MarkupEntityMismatch" -> innermost(" is still open where the file ends");
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
