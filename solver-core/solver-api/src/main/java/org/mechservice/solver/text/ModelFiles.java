package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The files that a model names: tables in CSV, closed surfaces in STL, and parts in further MechML
 * files. Whoever reads a model from a folder writes what they hold into its text, so that the text
 * holds the whole model when it travels: a table or map gets its points, a surface its volume and
 * moments, each with the {@code sha256} of the file; the text of an included file is appended, word
 * for word so that messages name its lines. A part that the text holds already stays.
 *
 * <p>All names are relative to the model's folder, also those in included files, and the files lie
 * in that folder or below it, also where they are links.
 */
public final class ModelFiles {
  private static final Pattern PLACE =
      Pattern.compile(
          "<!--.*?-->|<!\\[CDATA\\[.*?]]>|<(?:table|map|mesh|include|included)\\s[^<>]*>",
          Pattern.DOTALL);
  private static final Pattern ENCODING =
      Pattern.compile(
          "^(?:\u00ef\u00bb\u00bf)?<\\?xml[^>]*\\sencoding\\s*=\\s*[\"']([\\w.:-]+)[\"']");
  private static final Pattern OTHER_ENCODING =
      Pattern.compile("^<\\?xml[^>]*\\sencoding\\s*=\\s*[\"'](?!(?i:utf-8|us-ascii)[\"'])");
  private static final String END = "</MechML>";
  private static final String BYTE_ORDER_MARK = "\u00ef\u00bb\u00bf";

  private final Path model;
  private final Charset charset;
  private final Set<String> included = new HashSet<>();
  private final Deque<String> toInclude = new ArrayDeque<>();
  private boolean changed;

  private ModelFiles(Path model, Charset charset) {
    this.model = model;
    this.charset = charset;
  }

  /**
   * Returns a model file with what the files hold that it names.
   *
   * @param model its bytes; not modified
   * @param file the model file, beside which or below whose folder the others lie
   * @throws IOException if a file cannot be read or cannot be used; the message says which and why
   */
  public static byte[] inlined(byte[] model, Path file) throws IOException {
    String bytes = new String(model, StandardCharsets.ISO_8859_1);
    ModelFiles files = new ModelFiles(file, charset(bytes));
    String text = files.filled(bytes);
    int end = text.lastIndexOf(END);
    if (!files.toInclude.isEmpty() && end >= 0) {
      text = text.substring(0, end) + files.appended(text) + text.substring(end);
      files.changed = true;
    }
    return files.changed ? text.getBytes(StandardCharsets.ISO_8859_1) : model;
  }

  /** Returns the text of a model, in the encoding that it declares; UTF-8 if it declares none. */
  public static String text(byte[] model) {
    return new String(model, charset(new String(model, StandardCharsets.ISO_8859_1)));
  }

  /** Returns the encoding that a model declares; UTF-8 if it declares none or an unknown one. */
  private static Charset charset(String model) {
    Matcher declared = ENCODING.matcher(model);
    try {
      return declared.find() ? Charset.forName(declared.group(1)) : StandardCharsets.UTF_8;
    } catch (IllegalArgumentException e) {
      return StandardCharsets.UTF_8; // the reader of the model refuses it
    }
  }

  /** Returns an attribute of a tag in the model's encoding; the text holds its bytes. */
  private Optional<String> decoded(String element, String name) {
    return attribute(element, name)
        .map(text -> new String(text.getBytes(StandardCharsets.ISO_8859_1), charset));
  }

  /** Returns a text with its tables and surfaces filled in; notes the files that it includes. */
  private String filled(String text) throws IOException {
    StringBuilder all = new StringBuilder();
    Matcher found = PLACE.matcher(text);
    int from = 0;
    while (found.find()) {
      String element = found.group();
      Optional<String> name = attribute(element, "file");
      if (name.isEmpty() || element.startsWith("<!")) {
        continue;
      }
      if (element.startsWith("<included")) {
        included.add(name.get());
        toInclude.remove(name.get());
      } else if (element.startsWith("<include")) {
        if (included.add(name.get())) {
          toInclude.add(name.get());
        }
      } else {
        String more = attributes(element, name.get());
        int end = found.end() - (element.endsWith("/>") ? 2 : 1);
        all.append(text, from, end).append(more);
        from = end;
        changed |= !more.isEmpty();
      }
    }
    return from == 0 ? text : all.append(text.substring(from)).toString();
  }

  private String attributes(String element, String name) throws IOException {
    if (element.startsWith("<map")) {
      return attribute(element, "z").isEmpty()
          ? TableNumbers.ofMap(beside(name, "a map"), charset)
          : "";
    }
    if (element.startsWith("<table")) {
      boolean toFill = attribute(element, "x").isEmpty() && attribute(element, "y").isEmpty();
      return toFill
          ? TableNumbers.attributes(
              decoded(element, "xColumn"),
              decoded(element, "yColumn"),
              beside(name, "a table"),
              charset)
          : "";
    }
    return attribute(element, "volume").isEmpty()
        ? ClosedSurface.read(beside(name, "a mesh")).attributes()
        : "";
  }

  private String appended(String text) throws IOException {
    if (OTHER_ENCODING.matcher(text).find()) {
      throw new FileSystemException(
          model.toString(), null, "a model that includes files is in UTF-8; save it so");
    }
    StringBuilder all = new StringBuilder();
    while (!toInclude.isEmpty()) {
      String name = toInclude.remove();
      Path file = beside(name, "an include");
      byte[] content = Files.readAllBytes(file);
      String part = new String(content, StandardCharsets.ISO_8859_1);
      refuseWhatIsNoText(file, content);
      part = part.startsWith(BYTE_ORDER_MARK) ? part.substring(BYTE_ORDER_MARK.length()) : part;
      all.append("<included file=\"").append(name).append("\" sha256=\"");
      all.append(Sha256.of(content)).append("\"><![CDATA[");
      // A section cannot hold its own end, so that is divided between two.
      all.append(filled(part).replace("]]>", "]]]]><![CDATA[>")).append("]]></included>\n");
    }
    return all.toString();
  }

  private static void refuseWhatIsNoText(Path file, byte[] content) throws IOException {
    try {
      StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(content));
    } catch (CharacterCodingException e) {
      throw new FileSystemException(file.toString(), null, "it is not in UTF-8; save it so");
    }
    for (byte b : content) {
      if (b >= 0 && b < ' ' && b != '\t' && b != '\n' && b != '\r') {
        throw new FileSystemException(
            file.toString(), null, "it holds control characters and is no MechML");
      }
    }
  }

  /** Returns the text of an attribute of a tag. */
  static Optional<String> attribute(String element, String name) {
    Matcher found =
        Pattern.compile("\\s" + name + "\\s*=\\s*(\"([^\"]*)\"|'([^']*)')").matcher(element);
    return found.find()
        ? Optional.of(found.group(2) != null ? found.group(2) : found.group(3))
        : Optional.empty();
  }

  private Path beside(String name, String who) throws IOException {
    String utf = new String(name.getBytes(StandardCharsets.ISO_8859_1), charset);
    Path folder = model.toAbsolutePath().normalize().getParent();
    Path file = folder == null ? Path.of(utf) : folder.resolve(utf).normalize();
    if (folder == null || !file.startsWith(folder) || Path.of(utf).isAbsolute()) {
      throw new FileSystemException(
          utf, null, "the file of " + who + " lies in the model's folder or below it");
    }
    if (!Files.isRegularFile(file)) {
      throw new FileSystemException(
          file.toString(), null, who + " names this file, which does not exist");
    }
    if (!file.toRealPath().startsWith(folder.toRealPath())) {
      throw new FileSystemException(
          file.toString(), null, "the file of " + who + " is a link out of the model's folder");
    }
    return file;
  }
}
