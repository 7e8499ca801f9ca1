package org.mechservice.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.ext.heading.anchor.IdGenerator;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.CustomNode;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.Heading;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.node.Paragraph;
import org.commonmark.node.SoftLineBreak;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.AttributeProvider;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * A page of the guide, made of a Markdown file.
 *
 * @param source the file, relative to the top of the repository
 * @param title its first heading
 * @param html the page's text, without its frame
 * @param sections its headings of the second level, with their texts, in order; the first has the
 *     title and what stands before the second
 * @param files files and folders of the repository that it links or shows, relative to the top
 */
record GuidePage(Path source, String title, String html, List<Section> sections, Set<Path> files) {
  /**
   * A heading and the text below it.
   *
   * @param anchor empty for the page's title
   * @param level of the heading, 1 to 6
   */
  record Section(String anchor, String heading, int level, String text) {}

  private static final String MARKDOWN = ".md";

  /** File of the page of a folder. */
  static final String INDEX = "index.html";

  /** The repository's own page; at its place the site begins with that of the guide. */
  private static final Path FRONT = Path.of("README.md");

  /** Characters of code, and of a cell of a table, that are not broken into lines. */
  private static final int SHORT_CODE = 20;

  private static final int SHORT_CELL = 10;

  private static final List<Extension> EXTENSIONS =
      List.of(TablesExtension.create(), HeadingAnchorExtension.create());
  private static final Parser PARSER = Parser.builder().extensions(EXTENSIONS).build();
  private static final HtmlRenderer HTML =
      HtmlRenderer.builder()
          .extensions(EXTENSIONS)
          .attributeProviderFactory(context -> new Attributes())
          .escapeHtml(true)
          .build();

  /** Returns where the page of a Markdown file lies below the folder of the site. */
  static Path target(Path source) {
    String name = source.getFileName().toString();
    if (source.equals(FRONT)) {
      return Path.of("mechservice.html");
    }
    return source.resolveSibling(
        name.equals("README.md") ? INDEX : name.replaceAll("\\.md$", ".html"));
  }

  /**
   * Returns the page of a file.
   *
   * @param source the file, relative to the top
   * @param isFolder whether a path relative to the top is a folder: a link to it leads to its page
   */
  static GuidePage of(Path source, String markdown, Predicate<Path> isFolder) {
    Node document = PARSER.parse(markdown);
    Set<Path> files = new LinkedHashSet<>();
    document.accept(new LinkTurner(source, isFolder, files));
    List<Section> sections = sections(document);
    return new GuidePage(source, sections.get(0).heading(), HTML.render(document), sections, files);
  }

  private static List<Section> sections(Node document) {
    IdGenerator anchors = IdGenerator.builder().build();
    List<Section> sections = new ArrayList<>();
    StringBuilder text = new StringBuilder();
    Section open = new Section("", "", 1, "");
    for (Node node = document.getFirstChild(); node != null; node = node.getNext()) {
      if (node instanceof Heading heading) {
        String words = words(heading);
        String anchor = anchors.generateId(words);
        if (!open.heading().isEmpty()) {
          sections.add(new Section(open.anchor(), open.heading(), open.level(), text.toString()));
        }
        text.setLength(0);
        open =
            new Section(
                sections.isEmpty() && open.heading().isEmpty() ? "" : anchor,
                words,
                heading.getLevel(),
                "");
      } else {
        text.append(words(node)).append(' ');
      }
    }
    sections.add(new Section(open.anchor(), open.heading(), open.level(), text.toString()));
    return List.copyOf(sections);
  }

  /** Returns the words of a part of a page, without marks and addresses. */
  private static String words(Node part) {
    WordCollector collector = new WordCollector();
    part.accept(collector);
    return collector.words.toString().strip();
  }

  private static final class WordCollector extends AbstractVisitor {
    private final StringBuilder words = new StringBuilder();

    @Override
    public void visit(Text text) {
      words.append(text.getLiteral());
    }

    @Override
    public void visit(Code code) {
      words.append(code.getLiteral());
    }

    @Override
    public void visit(FencedCodeBlock code) {
      words.append(code.getLiteral()).append(' ');
    }

    @Override
    public void visit(SoftLineBreak end) {
      words.append(' ');
    }

    @Override
    public void visit(Paragraph paragraph) {
      visitChildren(paragraph);
      words.append(' ');
    }

    /** A row or cell of a table. */
    @Override
    public void visit(CustomNode cell) {
      visitChildren(cell);
      words.append(' ');
    }
  }

  /** Turns links between files of the repository into links between pages, and notes the files. */
  private static final class LinkTurner extends AbstractVisitor {
    private final Path source;
    private final Predicate<Path> isFolder;
    private final Set<Path> files;

    LinkTurner(Path source, Predicate<Path> isFolder, Set<Path> files) {
      this.source = source;
      this.isFolder = isFolder;
      this.files = files;
    }

    @Override
    public void visit(Link link) {
      link.setDestination(turned(link.getDestination()));
      visitChildren(link);
    }

    @Override
    public void visit(Image image) {
      image.setDestination(turned(image.getDestination()));
      visitChildren(image);
    }

    private String turned(String destination) {
      if (destination.matches("[a-z]+:.*|#.*")) {
        return destination;
      }
      String[] parts = destination.split("#", 2);
      Path file = source.resolveSibling(parts[0]).normalize();
      files.add(file);
      String place = parts[0];
      if (place.endsWith(MARKDOWN)) {
        place = Frame.link(source, target(file));
      } else if (isFolder.test(file)) {
        place = Frame.link(source, file.resolve(INDEX));
      }
      return parts.length == 1 ? place : place + "#" + parts[1];
    }
  }

  /**
   * Wide tables and code scroll by themselves: the keyboard must reach them. Short words of code
   * and short cells, such as a number with its unit, stay in one line.
   */
  private static final class Attributes implements AttributeProvider {
    @Override
    public void setAttributes(Node node, String tag, Map<String, String> attributes) {
      if (tag.equals("pre")) {
        attributes.put("tabindex", "0");
      } else if (tag.equals("img")) {
        attributes.put("loading", "lazy");
      } else if ((tag.equals("code") && words(node).length() <= SHORT_CODE)
          || (tag.equals("td") && words(node).length() <= SHORT_CELL)) {
        attributes.put("class", "short");
      }
    }
  }
}
