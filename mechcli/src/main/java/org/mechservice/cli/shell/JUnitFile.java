package org.mechservice.cli.shell;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.mechservice.solver.text.WellFormedText;

/**
 * Answers of a command as test cases, in the XML of JUnit that servers of continuous integration
 * read.
 */
public final class JUnitFile {
  private record Case(String name, Optional<String> failure) {}

  private final String suite;
  private final List<Case> cases = new ArrayList<>();

  /**
   * @param suite what is tested, such as {@code mech check car.xml}
   */
  public JUnitFile(String suite) {
    this.suite = suite;
  }

  /** Adds a case that has passed. */
  public void passed(String name) {
    cases.add(new Case(name, Optional.empty()));
  }

  /**
   * Adds a case that has failed.
   *
   * @param why its first line is the message
   */
  public void failed(String name, String why) {
    cases.add(new Case(name, Optional.of(why)));
  }

  /**
   * Writes the file.
   *
   * @throws IOException if it cannot be written
   * @throws UsageException S-046 if its name cannot be used
   */
  public void write(Path file) throws IOException {
    OutputFile.write(file, text().getBytes(StandardCharsets.UTF_8));
  }

  private String text() {
    StringWriter text = new StringWriter();
    try {
      XMLStreamWriter xml = XMLOutputFactory.newFactory().createXMLStreamWriter(text);
      xml.writeStartDocument("UTF-8", "1.0");
      xml.writeCharacters("\n");
      xml.writeStartElement("testsuite");
      attribute(xml, "name", suite);
      attribute(xml, "tests", Integer.toString(cases.size()));
      attribute(
          xml,
          "failures",
          Long.toString(cases.stream().filter(one -> one.failure().isPresent()).count()));
      attribute(xml, "errors", "0");
      for (Case one : cases) {
        xml.writeCharacters("\n  ");
        xml.writeStartElement("testcase");
        attribute(xml, "classname", suite);
        attribute(xml, "name", one.name());
        if (one.failure().isPresent()) {
          String why = WellFormedText.of(one.failure().get());
          xml.writeStartElement("failure");
          attribute(xml, "message", why.lines().findFirst().orElse(""));
          xml.writeCharacters(why);
          xml.writeEndElement();
        }
        xml.writeEndElement();
      }
      xml.writeCharacters("\n");
      xml.writeEndElement();
      xml.writeCharacters("\n");
      xml.writeEndDocument();
      xml.close();
    } catch (XMLStreamException e) {
      throw new IllegalStateException("XML in memory cannot fail", e);
    }
    return text.toString();
  }

  private static void attribute(XMLStreamWriter xml, String name, String value)
      throws XMLStreamException {
    xml.writeAttribute(name, WellFormedText.of(value));
  }
}
