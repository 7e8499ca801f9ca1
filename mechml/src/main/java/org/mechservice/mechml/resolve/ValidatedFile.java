package org.mechservice.mechml.resolve;

import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.include.IncludedParts;

/**
 * A model file whose text has been read and validated, with the files that it includes. It is
 * resolved as often as its parameters have other values; the text and its grammar are read once.
 * Immutable.
 */
public final class ValidatedFile {
  private final Element root;
  private final Diagnostics found;

  private ValidatedFile(Element root, Diagnostics found) {
    this.root = root;
    this.found = found;
  }

  /**
   * Reads and validates a file. No other file is opened; the grammar is the bundled one.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @throws MechmlException if a file is not well-formed or not valid, or is not there
   */
  public static ValidatedFile of(String fileName, byte[] content) throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(fileName);
    Element root = IncludedParts.put(DocumentReader.read(content, diagnostics).root(), diagnostics);
    return new ValidatedFile(root, diagnostics);
  }

  /**
   * Returns the element MechML, in which the parts of included files stand in place of {@code
   * include}.
   */
  public Element root() {
    return root;
  }

  /**
   * Resolves the model.
   *
   * @param options the chosen simulation and the parameters to set
   * @throws MechmlException if the file is not a mechanism, or if the options name a simulation or
   *     parameter that the file lacks
   */
  public MechmlModel model(ReadOptions options) throws MechmlException {
    MechmlModel read = ModelResolver.resolve(root, options, found.copy());
    return options.analysis().map(read::analysed).orElse(read);
  }
}
