package org.mechservice.solver.pack;

import java.io.IOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The constants of all classes together. Each is told in full where it is used first, and from then
 * on by its place among those of its kind; a field or method by its class and its place among those
 * of the class.
 */
final class Constants {
  private static final int NONE = 0;
  private static final int NEW = 1;
  private static final int SELF = 2;
  private static final int OTHER_KIND = 1;
  private static final int KNOWN = 3;
  private static final int BANDS_PER_KIND = 6;
  private static final int LONGEST_TEXT = 0xffff;

  /** Bands of texts that are types. */
  private static final BitSet TYPES = new BitSet();

  static {
    TYPES.set(BandNumbers.COMPONENT_TYPE);
    TYPES.set(BandNumbers.TABLE + BANDS_PER_KIND * Constant.NAME_AND_TYPE + 3);
    TYPES.set(BandNumbers.TABLE + BANDS_PER_KIND * Constant.METHOD_TYPE + 1);
  }

  /** Constants of a kind, or members of a kind of a class, in the order of their first use. */
  private static final class Known {
    private final List<Constant> list = new ArrayList<>();
    private final Map<Constant, Integer> places = new HashMap<>();

    void add(Constant constant) {
      places.put(constant, list.size());
      list.add(constant);
    }

    Constant at(int place) throws IOException {
      if (place < 0 || place >= list.size()) {
        throw new IOException("the packed classes refer to a constant that is not there");
      }
      return list.get(place);
    }

    /** Returns the place of a constant, -1 if it is not known. */
    int place(Constant constant) {
      return places.getOrDefault(constant, -1);
    }
  }

  private final Symbols symbols;
  private final Known[] ofTag = new Known[Constant.LAST_TAG + 1];
  private final Map<Constant, Known[]> membersOf = new HashMap<>();
  private Constant self = Constant.NONE;

  Constants(Symbols symbols) {
    this.symbols = symbols;
    for (int tag = 0; tag < ofTag.length; tag++) {
      ofTag[tag] = new Known();
    }
  }

  /**
   * Carries a constant of a kind, or {@link Constant#NONE}.
   *
   * @param band the first of three for the purpose it has
   * @param given the constant; of no meaning where symbols are read
   */
  Constant any(int band, int tag, Constant given) throws IOException {
    if (Constant.isMember(tag)) {
      return member(band, tag, given);
    }
    if (band == BandNumbers.THIS) {
      self = Constant.NONE;
      self = other(band, tag, given);
      return self;
    }
    return other(band, tag, given);
  }

  private Constant other(int band, int tag, Constant given) throws IOException {
    int place = ofTag[tag].place(given);
    int told = NEW;
    if (given.tag() == 0) {
      told = NONE;
    } else if (given.equals(self)) {
      told = SELF;
    } else if (place >= 0) {
      told = KNOWN + (place >> Byte.SIZE);
    }
    told = symbols.symbol(band, told);
    return switch (told) {
      case NONE -> Constant.NONE;
      case SELF -> self;
      case NEW -> {
        Constant constant = whole(band, tag, given);
        ofTag[tag].add(constant);
        yield constant;
      }
      default -> {
        int low = symbols.symbol(band + 1, place & 0xff);
        yield ofTag[tag].at((told - KNOWN) << Byte.SIZE | low);
      }
    };
  }

  /** The class of a member, then which of its members. */
  private Constant member(int band, int usual, Constant given) throws IOException {
    int kind = given.tag() == 0 || given.tag() == usual ? 0 : OTHER_KIND;
    int tag =
        symbols.symbol(BandNumbers.MEMBER_KIND, kind) == 0 ? usual : Constant.INTERFACE_METHOD;
    Constant owner = other(band, Constant.CLASS, part(given, 0));
    return owner.tag() == 0 ? owner : memberOf(owner, band + 2, tag, part(given, 1));
  }

  /** Carries a field or method that the class has: its name and type. */
  Constant own(int band, int tag, Constant given) throws IOException {
    return part(memberOf(self, band, tag, given), 1);
  }

  private Constant memberOf(Constant owner, int band, int tag, Constant given) throws IOException {
    Known[] kinds = membersOf.computeIfAbsent(owner, any -> newKinds());
    Known known = kinds[tag - Constant.FIELD];
    int told = symbols.small(band, known.place(given) + 1);
    if (told == 0) {
      known.add(other(BandNumbers.TABLE + BANDS_PER_KIND * tag, Constant.NAME_AND_TYPE, given));
    }
    Constant name = known.at(told == 0 ? known.list.size() - 1 : told - 1);
    return new Constant(tag, "", 0, List.of(owner, name));
  }

  private static Known[] newKinds() {
    return new Known[] {new Known(), new Known(), new Known()};
  }

  private static Constant part(Constant given, int i) {
    return given.parts().isEmpty() ? Constant.NONE : given.parts().get(i);
  }

  private Constant whole(int band, int tag, Constant given) throws IOException {
    if (tag == Constant.UTF8) {
      return text(band, given);
    }
    int first = BandNumbers.TABLE + BANDS_PER_KIND * tag;
    long bits = 0;
    for (int i = Constant.numberSize(tag) - 1; i >= 0; i--) {
      int next = symbols.symbol(first, (int) (given.bits() >>> (Byte.SIZE * i)) & 0xff);
      bits = bits << Byte.SIZE | next;
    }
    List<Constant> parts = new ArrayList<>();
    List<Integer> kinds = Constant.partsOf(tag, bits);
    for (int i = 0; i < kinds.size(); i++) {
      parts.add(any(first + 1 + 2 * i, kinds.get(i), part(given, i)));
    }
    return new Constant(tag, "", bits, parts);
  }

  /** A text ends with a zero, which none contains; a type names its classes by reference. */
  private Constant text(int band, Constant given) throws IOException {
    boolean isType = TYPES.get(band);
    String known = given.text();
    StringBuilder text = new StringBuilder();
    while (true) {
      int at = text.length();
      symbols.surroundings().expect(band);
      int next = symbols.symbol(BandNumbers.TEXT, at < known.length() ? known.charAt(at) : 0);
      if (next == 0) {
        return new Constant(Constant.UTF8, text.toString(), 0, List.of());
      }
      text.append((char) next);
      if (at > LONGEST_TEXT) {
        throw new IOException("a text of the packed classes is too long");
      }
      if (isType && next == 'L') {
        text.append(className(at + 1 < known.length() ? known.substring(at + 1) : ""));
      }
    }
  }

  /** The name of a class within a type, up to its semicolon. */
  private String className(String known) throws IOException {
    Constant given = Constant.NONE;
    if (!known.isEmpty()) {
      String name = known.substring(0, known.indexOf(';'));
      Constant text = new Constant(Constant.UTF8, name, 0, List.of());
      given = new Constant(Constant.CLASS, "", 0, List.of(text));
    }
    Constant read = other(BandNumbers.TYPE_CLASS, Constant.CLASS, given);
    return read.tag() == 0 ? "" : read.parts().get(0).text() + ';';
  }
}
