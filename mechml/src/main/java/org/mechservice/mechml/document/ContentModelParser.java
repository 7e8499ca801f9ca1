package org.mechservice.mechml.document;

import java.util.ArrayList;
import java.util.List;
import java.util.StringTokenizer;

/** Reads content models as the XML parser reports them: {@code (body1,body2)}, {@code EMPTY}. */
final class ContentModelParser {
  private static final String TEXT = "(#PCDATA)";

  private final StringTokenizer words;
  private String word;

  private ContentModelParser(String model) {
    this.words = new StringTokenizer(model, "(),|?*+ ", true);
    this.word = "";
    advance();
  }

  /**
   * Reads a content model.
   *
   * @throws IllegalArgumentException if the model is ANY or mixes text and elements, which MechML
   *     does not use
   */
  static ContentModel parse(String model) {
    if (model.equals("EMPTY") || model.equals(TEXT)) {
      return ContentModel.EMPTY;
    }
    if (model.equals("ANY") || model.contains("#PCDATA")) {
      throw new IllegalArgumentException("MechML elements hold elements: " + model);
    }
    return new ContentModelParser(model).part();
  }

  private ContentModel part() {
    ContentModel part = word.equals("(") ? group() : new ContentModel.Child(advance());
    return switch (word) {
      case "?" -> repeated(part, true, false);
      case "*" -> repeated(part, true, true);
      case "+" -> repeated(part, false, true);
      default -> part;
    };
  }

  private ContentModel repeated(ContentModel part, boolean optional, boolean unbounded) {
    advance();
    return new ContentModel.Repeated(part, optional, unbounded);
  }

  private ContentModel group() {
    advance();
    List<ContentModel> parts = new ArrayList<>();
    parts.add(part());
    boolean choice = word.equals("|");
    while (!word.equals(")")) {
      advance();
      parts.add(part());
    }
    advance();
    return choice ? new ContentModel.Choice(parts) : new ContentModel.Sequence(parts);
  }

  private String advance() {
    String passed = word;
    do {
      word = words.hasMoreTokens() ? words.nextToken() : "";
    } while (word.equals(" "));
    return passed;
  }
}
