package org.mechservice.mechml.resolve;

import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;

/** Reads MechML files. */
public final class MechmlReader {
  private MechmlReader() {}

  /**
   * Reads, validates and resolves a model file with default options.
   *
   * @see #read(String, byte[], ReadOptions)
   */
  public static MechmlModel read(String fileName, byte[] content) throws MechmlException {
    return read(fileName, content, ReadOptions.NONE);
  }

  /**
   * Reads, validates and resolves a model file. The reader opens no other file; it uses the bundled
   * DTD.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @param options the chosen simulation and the parameters to set
   * @return the model
   * @throws MechmlException if the file is not well-formed, not valid, or not a mechanism, or if
   *     the options name a simulation or parameter that the file lacks
   */
  public static MechmlModel read(String fileName, byte[] content, ReadOptions options)
      throws MechmlException {
    return ValidatedFile.of(fileName, content).model(options);
  }

  /**
   * Reads and validates a model file with the files that it includes, without resolving it.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @return the element MechML, in which the parts of included files stand in place of {@code
   *     include}
   * @throws MechmlException if a file is not well-formed or not valid, or is not there
   */
  public static Element whole(String fileName, byte[] content) throws MechmlException {
    return ValidatedFile.of(fileName, content).root();
  }

  /**
   * Reads and validates a model file without resolving it. {@link
   * org.mechservice.mechml.document.DocumentWriter} writes the document back to text.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @throws MechmlException if the file is not well-formed or not valid
   */
  public static Document document(String fileName, byte[] content) throws MechmlException {
    return DocumentReader.read(content, new Diagnostics(fileName));
  }
}
