package org.mechservice.solver.pack;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The constants of all classes together, of every kind in an order in which neighbours are alike:
 * texts by their beginnings, members by their classes.
 */
final class ConstantTable {
  private static final int BANDS_PER_KIND = 4;

  private final List<List<Constant>> ofTag = new ArrayList<>();

  /** For members: the place of each one's class among the classes, ascending. */
  private final List<List<Integer>> ownersOf = new ArrayList<>();

  /** Places of constants; only where a table is written. */
  private final Map<Constant, Integer> indexOf = new HashMap<>();

  private ConstantTable() {
    for (int tag = 0; tag <= Constant.LAST_TAG; tag++) {
      ofTag.add(new ArrayList<>());
      ownersOf.add(new ArrayList<>());
    }
  }

  /** Makes the table of given constants, and of all they refer to. */
  static ConstantTable of(Set<Constant> constants) {
    ConstantTable table = new ConstantTable();
    constants.forEach(table::collect);
    for (int tag : Constant.TAGS) {
      List<Constant> list = table.ofTag.get(tag);
      list.sort(table.order());
      for (int i = 0; i < list.size(); i++) {
        table.indexOf.put(list.get(i), i);
        if (Constant.isMember(tag)) {
          table.ownersOf.get(tag).add(table.index(list.get(i).parts().get(0)));
        }
      }
    }
    return table;
  }

  private void collect(Constant constant) {
    if (indexOf.putIfAbsent(constant, -1) == null) {
      ofTag.get(constant.tag()).add(constant);
      constant.parts().forEach(this::collect);
    }
  }

  private Comparator<Constant> order() {
    return (a, b) -> {
      for (int i = 0; i < a.parts().size(); i++) {
        int byTag = Integer.compare(a.parts().get(i).tag(), b.parts().get(i).tag());
        int byPart =
            byTag != 0 ? byTag : Integer.compare(index(a.parts().get(i)), index(b.parts().get(i)));
        if (byPart != 0) {
          return byPart;
        }
      }
      int byText = a.text().compareTo(b.text());
      return byText != 0 ? byText : Long.compareUnsigned(a.bits(), b.bits());
    };
  }

  /** Returns the place of a constant among those of its kind. */
  int index(Constant constant) {
    return indexOf.getOrDefault(constant, -1);
  }

  /**
   * Returns the constant of a kind at a place.
   *
   * @throws IOException if there is none
   */
  Constant at(int tag, int index) throws IOException {
    if (tag > Constant.LAST_TAG || index < 0 || index >= ofTag.get(tag).size()) {
      throw new IOException("the packed classes refer to a constant that is not there");
    }
    return ofTag.get(tag).get(index);
  }

  /** Returns where the members of the class at {@code owner} begin among those of a kind. */
  int firstMember(int tag, int owner) {
    List<Integer> owners = ownersOf.get(tag);
    int low = 0;
    int high = owners.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (owners.get(middle) < owner) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  void write(Bands bands) {
    for (int tag : Constant.TAGS) {
      int band = BandNumbers.TABLE + BANDS_PER_KIND * tag;
      List<Constant> list = ofTag.get(tag);
      bands.putSmall(BandNumbers.TABLE_LENGTH, list.size());
      if (tag == Constant.UTF8) {
        writeTexts(bands, band, list);
      } else {
        writeOthers(bands, band, list);
      }
    }
  }

  private static void writeTexts(Bands bands, int band, List<Constant> list) {
    String before = "";
    for (Constant constant : list) {
      String text = constant.text();
      int same = 0;
      while (same < Math.min(text.length(), before.length())
          && text.charAt(same) == before.charAt(same)) {
        same++;
      }
      bands.putSmall(band, same);
      bands.putSmall(band + 1, text.length() - same);
      for (int i = same; i < text.length(); i++) {
        bands.put(band + 2, text.charAt(i));
      }
      before = text;
    }
  }

  /** The first part as difference; the second too where the first is the same. */
  private void writeOthers(Bands bands, int band, List<Constant> list) {
    int first = 0;
    int second = 0;
    for (Constant constant : list) {
      int size = Constant.numberSize(constant.tag());
      for (int i = size - 1; i >= 0; i--) {
        bands.put(band + 3, (int) (constant.bits() >>> (Byte.SIZE * i)));
      }
      if (!constant.parts().isEmpty()) {
        if (constant.tag() == Constant.METHOD_HANDLE) {
          bands.put(band + 3, constant.parts().get(0).tag());
        }
        int part = index(constant.parts().get(0));
        bands.putSigned(band, part - first);
        if (constant.parts().size() > 1) {
          int next = index(constant.parts().get(1));
          if (part == first) {
            bands.putSigned(band + 3, next - second);
          } else {
            bands.putPair(band + 1, next);
          }
          second = next;
        }
        first = part;
      }
    }
  }

  /**
   * Reads what {@link #write} wrote.
   *
   * @throws IOException if it is damaged
   */
  static ConstantTable read(Bands bands) throws IOException {
    ConstantTable table = new ConstantTable();
    for (int tag : Constant.TAGS) {
      int band = BandNumbers.TABLE + BANDS_PER_KIND * tag;
      int count = bands.getSmall(BandNumbers.TABLE_LENGTH);
      if (tag == Constant.UTF8) {
        table.readTexts(bands, band, count);
      } else {
        table.readOthers(bands, band, tag, count);
      }
    }
    return table;
  }

  private void add(Constant constant) {
    ofTag.get(constant.tag()).add(constant);
  }

  private void readTexts(Bands bands, int band, int count) throws IOException {
    String before = "";
    for (int i = 0; i < count; i++) {
      int same = bands.getSmall(band);
      int more = bands.getSmall(band + 1);
      if (same < 0 || same > before.length()) {
        throw new IOException("the packed classes have a damaged text");
      }
      StringBuilder text = new StringBuilder(before.substring(0, same));
      for (int k = 0; k < more; k++) {
        text.append((char) bands.get(band + 2));
      }
      before = text.toString();
      add(new Constant(Constant.UTF8, before, 0, List.of()));
    }
  }

  private void readOthers(Bands bands, int band, int tag, int count) throws IOException {
    List<Integer> kinds = Constant.partsOf(tag);
    int first = 0;
    int second = 0;
    for (int i = 0; i < count; i++) {
      long bits = 0;
      for (int k = 0; k < Constant.numberSize(tag); k++) {
        bits = (bits << Byte.SIZE) | bands.get(band + 3);
      }
      List<Constant> parts = new ArrayList<>();
      if (!kinds.isEmpty()) {
        int kind = tag == Constant.METHOD_HANDLE ? bands.get(band + 3) : kinds.get(0);
        int part = first + bands.getSigned(band);
        parts.add(at(kind, part));
        ownersOf.get(tag).add(part);
        if (kinds.size() > 1) {
          second = part == first ? second + bands.getSigned(band + 3) : bands.getPair(band + 1);
          parts.add(at(kinds.get(1), second));
        }
        first = part;
      }
      add(new Constant(tag, "", bits, parts));
    }
  }
}
