package org.mechservice.mechml.document;

import java.util.List;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.solver.catalogue.MessageCode;
import org.xml.sax.SAXException;
import org.xml.sax.ext.DefaultHandler2;

/**
 * Reads the grammar from the declarations of the bundled DTD. A model file itself may declare short
 * entities only; every other declaration is refused.
 */
final class GrammarReader extends DefaultHandler2 {
  private final Grammar grammar = new Grammar();
  private final BundledDtd dtd;
  private final ParserPosition here;

  /**
   * Begins with an empty grammar.
   *
   * @param dtd knows whether a declaration comes from the bundled DTD or from the file
   * @param here position of the declaration being read
   */
  GrammarReader(BundledDtd dtd, ParserPosition here) {
    this.dtd = dtd;
    this.here = here;
  }

  Grammar grammar() {
    return grammar;
  }

  @Override
  public void elementDecl(String name, String model) throws SAXException {
    refuseUnlessBundled("element " + Quoted.of(name));
    grammar.addElement(name, ContentModelParser.parse(model));
  }

  @Override
  public void attributeDecl(
      String element, String attribute, String type, String mode, String defaultValue)
      throws SAXException {
    refuseUnlessBundled("attribute " + Quoted.of(attribute));
    List<String> choices =
        type.startsWith("(")
            ? List.of(type.substring(1, type.length() - 1).split("\\|", -1))
            : List.of();
    boolean required = "#REQUIRED".equals(mode);
    grammar.addAttribute(element, attribute, new Grammar.AttributeRule(required, choices));
  }

  @Override
  public void internalEntityDecl(String name, String value) throws SAXException {
    if (name.startsWith("%")) {
      refuseUnlessBundled("parameter entity " + Quoted.of(name.substring(1)));
    }
    if (value.length() > Limits.ENTITY_LENGTH) {
      throw new RejectedFileException(
          MessageCode.MODEL_FILE_TOO_LARGE,
          here.position(),
          Phrase.of(
              "entity %s has %d characters; %d are allowed",
              Quoted.of(name), value.length(), Limits.ENTITY_LENGTH));
    }
  }

  @Override
  public void externalEntityDecl(String name, String publicId, String systemId)
      throws SAXException {
    throw new RejectedFileException(
        MessageCode.REFERS_TO_OTHER_FILE,
        here.position(),
        Phrase.of(
            "entity %s refers to another file, %s; a model file must not refer to other files",
            Quoted.of(name), Quoted.of(systemId)));
  }

  private void refuseUnlessBundled(String what) throws RejectedFileException {
    if (!dtd.isServed()) {
      throw new RejectedFileException(
          MessageCode.DOCTYPE_DECLARES,
          here.position(),
          Phrase.of(
              "the DOCTYPE declares %s itself; mechml.dtd defines the language, and a file may add"
                  + " only entities",
              what));
    }
  }
}
