package org.mechservice.mechml.document;

import java.util.List;
import java.util.Optional;

/**
 * A model file as a tree of elements, with expressions, units and comments as written.
 *
 * @param systemId name of the grammar in its DOCTYPE, such as {@code MechML.dtd}; empty without
 *     DOCTYPE
 * @param prolog comments before the outermost element
 * @param root the element MechML
 * @param epilog comments after it
 */
public record Document(
    Optional<String> systemId, List<Comment> prolog, Element root, List<Comment> epilog) {
  public Document {
    prolog = List.copyOf(prolog);
    epilog = List.copyOf(epilog);
  }

  /** Returns the DTD of MechML. */
  public static String dtd() {
    return BundledDtd.text();
  }

  /** Returns a document of its root alone, whose DOCTYPE names {@code mechml.dtd}. */
  public static Document of(Element root) {
    return new Document(Optional.of("mechml.dtd"), List.of(), root, List.of());
  }
}
