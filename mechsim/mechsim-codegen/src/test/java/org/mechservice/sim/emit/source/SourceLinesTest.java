package org.mechservice.sim.emit.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Lines of generated source that are too long for one. */
class SourceLinesTest {
  @Test
  void aLiteralStaysWholeThoughItBeginsALineThatIsBrokenAgain() {
    String literal = "\"" + "1 2 ".repeat(17) + "\"";
    String text =
        new SourceLines()
            .line("super(" + literal + ", " + literal + ", " + literal + ");")
            .toString();
    assertThat(text.lines()).hasSize(3).allMatch(line -> line.contains(literal));
  }
}
