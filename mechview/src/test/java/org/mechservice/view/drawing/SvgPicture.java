package org.mechservice.view.drawing;

import java.awt.geom.Rectangle2D;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/** An SVG picture as a program that reads it sees it. */
public record SvgPicture(double width, double height, List<Label> labels, Document document) {
  /** Reads a picture; it must be well-formed XML. */
  public static SvgPicture read(String svg) throws Exception {
    Document document =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new InputSource(new StringReader(svg)));
    List<Label> labels = new ArrayList<>();
    NodeList texts = document.getElementsByTagName("text");
    for (int i = 0; i < texts.getLength(); i++) {
      Element text = (Element) texts.item(i);
      String anchor = text.getAttribute("text-anchor");
      labels.add(
          new Label(
              number(text, "x"),
              number(text, "y"),
              text.getTextContent(),
              number(text, "font-size"),
              anchor.equals("end")
                  ? Label.Anchoring.END
                  : anchor.equals("middle") ? Label.Anchoring.MIDDLE : Label.Anchoring.START,
              Ink.TEXT,
              text.getAttribute("font-weight").equals("bold"),
              text.getAttribute("transform").startsWith("rotate(-90")));
    }
    Element root = document.getDocumentElement();
    return new SvgPicture(number(root, "width"), number(root, "height"), labels, document);
  }

  private static double number(Element element, String attribute) {
    return Double.parseDouble(element.getAttribute(attribute));
  }

  /** Returns the texts. */
  public List<String> texts() {
    return labels.stream().map(Label::text).toList();
  }

  /** Returns the names of the parts that pointing at them shows. */
  public List<String> parts() {
    List<String> parts = new ArrayList<>();
    NodeList titles = document.getElementsByTagName("title");
    for (int i = 0; i < titles.getLength(); i++) {
      parts.add(titles.item(i).getTextContent());
    }
    return parts;
  }

  /** Returns texts that leave the picture, and pairs of texts that cover each other. */
  public List<String> illegible() {
    Rectangle2D page = new Rectangle2D.Double(0, 0, width, height);
    List<String> bad = new ArrayList<>();
    for (int i = 0; i < labels.size(); i++) {
      Rectangle2D box = labels.get(i).box();
      if (!page.contains(box)) {
        bad.add(labels.get(i).text() + " at " + box + " leaves the picture");
      }
      for (int j = 0; j < i; j++) {
        if (box.intersects(labels.get(j).box())) {
          bad.add(labels.get(i).text() + " covers " + labels.get(j).text());
        }
      }
    }
    return bad;
  }
}
