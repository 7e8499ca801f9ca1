package org.mechservice.solver.pack;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Carries a class file into bands; references are kept until the table of constants is known. */
final class Packing implements Transfer {
  private static final int BYTE = 0xff;

  /** A reference that is to be written: null stands for none. */
  private record Reference(int band, List<Constant> constant, int tag) {}

  private final byte[] file;
  private final ConstantPool pool;
  private final Bands bands;
  private final List<Reference> references = new ArrayList<>();
  private int at;

  Packing(byte[] file, Bands bands) {
    this.file = file;
    this.pool = ConstantPool.of(file);
    this.bands = bands;
    this.at = pool.end();
  }

  /** Adds the constants that were referred to. */
  void collect(Set<Constant> constants) {
    references.forEach(reference -> constants.addAll(reference.constant()));
  }

  /** Writes the references. */
  void writeReferences(ConstantTable table) {
    Constant self = references.get(0).constant().get(0);
    for (Reference reference : references) {
      if (reference.constant().isEmpty()) {
        writeNone(reference);
      } else if (Constant.isMember(reference.tag())) {
        writeMember(reference.band(), reference.constant().get(0), reference.tag(), self, table);
      } else {
        bands.putPair(reference.band(), table.index(reference.constant().get(0)) + 1);
      }
    }
  }

  private void writeNone(Reference reference) {
    if (Constant.isMember(reference.tag())) {
      bands.put(reference.band(), Members.NONE);
    } else {
      bands.putPair(reference.band(), 0);
    }
  }

  private void writeMember(
      int band, Constant member, int usual, Constant self, ConstantTable table) {
    int index = table.index(member);
    int own = index - table.firstMember(member.tag(), table.index(self));
    if (member.tag() == usual && member.parts().get(0).equals(self) && own <= Members.MOST_OWN) {
      bands.put(band, Members.OWN + own);
      return;
    }
    bands.put(band, member.tag() == usual ? Members.FAR : Members.OF_INTERFACE);
    bands.putPair(band + 1, index);
  }

  private int read(int bytes) {
    int value = 0;
    for (int i = 0; i < bytes; i++) {
      value = (value << Byte.SIZE) | (file[at++] & BYTE);
    }
    return value;
  }

  @Override
  public int byteOf(int band) {
    int value = read(1);
    bands.put(band, value);
    return value;
  }

  @Override
  public int small(int band) {
    int value = read(2);
    bands.putSmall(band, value);
    return value;
  }

  @Override
  public int pair(int band) {
    int value = read(2);
    bands.putPair(band, value);
    return value;
  }

  @Override
  public int signed(int band) {
    int value = (short) read(2);
    bands.putSigned(band, value);
    return value;
  }

  @Override
  public int wide(int band) {
    int value = read(4);
    bands.putSigned(band, value);
    return value;
  }

  @Override
  public String reference(int band, int tag) {
    int index = read(2);
    if (index == 0) {
      references.add(new Reference(band, List.of(), tag));
      return "";
    }
    Constant constant = pool.at(index);
    references.add(new Reference(band, List.of(constant), tag));
    return constant.text();
  }

  @Override
  public void loadable(int band, int bytes) {
    Constant constant = pool.at(read(bytes));
    bands.put(BandNumbers.LOADABLE_KIND, constant.tag());
    references.add(new Reference(band + 3 * constant.tag(), List.of(constant), constant.tag()));
  }

  @Override
  public void align(int start) {
    while ((at - start) % 4 != 0) {
      at++;
    }
  }

  @Override
  public int position() {
    return at;
  }

  @Override
  public int beginLength() {
    read(4);
    return at;
  }

  @Override
  public void endLength(int begin) {
    // The length follows from what was carried.
  }
}
