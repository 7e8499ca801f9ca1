package org.mechservice.mechml.document;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Quoted;

/**
 * Rewords the XML parser's errors for authors of models. The reworded messages take over the quoted
 * names of the parser's messages.
 */
final class ParserMessages {
  private static final Pattern QUOTED = Pattern.compile("\"([^\"]*+)\"");

  private static final Map<String, String> REWRITTEN =
      Map.ofEntries(
          Map.entry("PrematureEOF", "the file has no model; write one <MechML> element"),
          Map.entry(
              "MarkupNotRecognizedInContent",
              "\"<\" must begin a tag; write the character itself as &lt;"),
          Map.entry(
              "ContentIllegalInProlog",
              "this is not XML; a model file begins with <?xml version=\"1.0\"?> or <MechML>"),
          Map.entry(
              "MarkupNotRecognizedInProlog",
              "this is not XML; a model file begins with <?xml version=\"1.0\"?> or <MechML>"),
          Map.entry(
              "ContentIllegalInTrailingMisc",
              "there is text after the end of the model; a file has one <MechML> element"),
          Map.entry(
              "MarkupNotRecognizedInMisc",
              "there is text after the end of the model; a file has one <MechML> element"),
          Map.entry(
              "ReservedPITarget",
              "<?xml ...?> is permitted only at the very beginning of the file"),
          Map.entry("NameRequiredInReference", "write the character \"&\" as &amp;"),
          Map.entry("SemicolonRequiredInReference", "write the character \"&\" as &amp;"),
          Map.entry("OpenQuoteExpected", "the value of attribute {1} must be in quotes"),
          Map.entry("EqRequiredInAttribute", "attribute {1} of <{2}> has no value"),
          Map.entry("AttributeNotUnique", "attribute {1} occurs twice in <{2}>"),
          Map.entry(
              "LessthanInAttValue",
              "the character \"<\" in attribute {1} must be written &lt;, unless a quote is missing"
                  + " before it"),
          Map.entry("ElementUnterminated", "the tag <{1} lacks its end, \">\" or \"/>\""),
          Map.entry("VersionNotSupported", "only XML 1.0 is read; write <?xml version=\"1.0\"?>"),
          Map.entry("EntityExpansionLimitExceeded", "too many references to entities, over {1}"),
          Map.entry("EncodingDeclInvalid", "there is no encoding {1}; save the file as UTF-8"),
          Map.entry("EncodingNotSupported", "encoding {1} is not known; save the file as UTF-8"),
          Map.entry("InvalidByte", "a byte that is not UTF-8; save the file as UTF-8"),
          Map.entry("ExpectedByte", "a byte that is not UTF-8; save the file as UTF-8"),
          Map.entry("InvalidASCII", "a byte that is not ASCII; save the file as UTF-8"),
          Map.entry(
              "RootElementTypeMustMatchDoctypedecl",
              "the DOCTYPE names another element; write"
                  + " <!DOCTYPE MechML SYSTEM \"MechML.dtd\">"),
          Map.entry(
              "MSG_WHITE_SPACE_IN_ELEMENT_CONTENT_WHEN_STANDALONE",
              "standalone=\"yes\" does not apply to a model file; leave it out"));

  private ParserMessages() {}

  /**
   * Returns the reworded message, or the parser's message if it needs no change.
   *
   * @param key the parser's key of the error
   * @param sentence the parser's message
   */
  static String of(String key, String sentence) {
    String rewritten = REWRITTEN.get(key);
    return rewritten == null ? tidied(sentence) : filled(rewritten, sentence);
  }

  private static String filled(String rewritten, String sentence) {
    String filled = rewritten;
    Matcher quoted = QUOTED.matcher(sentence);
    for (int i = 1; quoted.find(); i++) {
      String name = String.valueOf(quoted.group(1));
      filled =
          filled
              .replace("<{" + i + "}", "<" + Quoted.plain(name))
              .replace("{" + i + "}", Quoted.of(name));
    }
    return filled;
  }

  private static String tidied(String sentence) {
    String text =
        QUOTED
            .matcher(sentence.strip())
            .replaceAll(q -> Matcher.quoteReplacement(Quoted.of(String.valueOf(q.group(1)))));
    return text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
  }
}
