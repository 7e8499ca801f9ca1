package org.mechservice.solver.pack;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;

/** Carries a class file out of symbols; its constant pool is made of what it turns out to need. */
final class Unpacking implements Transfer {
  private static final int MAGIC = 0xcafebabe;
  private static final int MOST_CONSTANTS = 0xffff;
  private static final int BYTE = 0xff;

  /** A place in the file where the index of a constant goes. */
  private record Place(int at, int bytes, Constant constant) {}

  private final Symbols symbols;
  private final Constants constants;
  private final List<Place> places = new ArrayList<>();
  private byte[] body = new byte[4096];
  private int at;

  Unpacking(Symbols symbols, Constants constants) {
    this.symbols = symbols;
    this.constants = constants;
  }

  /** Returns the class's internal name, once it is carried. */
  String name() throws IOException {
    Constant self = places.isEmpty() ? Constant.NONE : places.get(0).constant();
    if (self.tag() != Constant.CLASS) {
      throw new IOException("a packed class has no name");
    }
    return self.parts().get(0).text();
  }

  /** Returns the class file: what was carried, behind the constants it needs. */
  byte[] file(int version) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream(at + at);
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeInt(MAGIC);
    out.writeShort(0);
    out.writeShort(version);
    pool(out);
    out.write(body, 0, at);
    return bytes.toByteArray();
  }

  /** Constants that are loaded by a byte come first. */
  private void pool(DataOutputStream out) throws IOException {
    IdentityHashMap<Constant, Integer> indexOf = new IdentityHashMap<>();
    List<Constant> order = new ArrayList<>();
    int next = 1;
    for (int bytes = 1; bytes <= 2; bytes++) {
      for (Place place : places) {
        if (place.bytes() == bytes) {
          next = number(place.constant(), indexOf, order, next);
        }
      }
    }
    for (int i = 0; i < order.size(); i++) {
      for (Constant part : order.get(i).parts()) {
        next = number(part, indexOf, order, next);
      }
    }
    if (next > MOST_CONSTANTS) {
      throw new IOException("a packed class has too many constants");
    }
    out.writeShort(next);
    for (Constant constant : order) {
      write(constant, indexOf, out);
    }
    for (Place place : places) {
      int index = indexOf.getOrDefault(place.constant(), 0);
      if (place.bytes() == 2) {
        body[place.at()] = (byte) (index >> Byte.SIZE);
      } else if (index > BYTE) {
        throw new IOException("a packed class loads too many constants");
      }
      body[place.at() + place.bytes() - 1] = (byte) index;
    }
  }

  private static int number(
      Constant constant,
      IdentityHashMap<Constant, Integer> indexOf,
      List<Constant> order,
      int next) {
    if (indexOf.putIfAbsent(constant, next) != null) {
      return next;
    }
    order.add(constant);
    return next + (constant.isWide() ? 2 : 1);
  }

  private static void write(
      Constant constant, IdentityHashMap<Constant, Integer> indexOf, DataOutputStream out)
      throws IOException {
    out.writeByte(constant.tag());
    if (constant.tag() == Constant.UTF8) {
      out.writeShort(constant.text().length());
      out.writeBytes(constant.text());
    }
    for (int i = Constant.numberSize(constant.tag()) - 1; i >= 0; i--) {
      out.writeByte((int) (constant.bits() >>> (Byte.SIZE * i)));
    }
    for (Constant part : constant.parts()) {
      out.writeShort(indexOf.getOrDefault(part, 0));
    }
  }

  private int write(int value, int bytes) {
    if (at + bytes > body.length) {
      body = Arrays.copyOf(body, 2 * body.length);
    }
    for (int i = bytes - 1; i >= 0; i--) {
      body[at++] = (byte) (value >> (Byte.SIZE * i));
    }
    return value;
  }

  @Override
  public int byteOf(int band) throws IOException {
    return write(symbols.symbol(band, 0), 1);
  }

  @Override
  public int small(int band) throws IOException {
    return write(symbols.small(band, 0), 2);
  }

  @Override
  public int pair(int band) throws IOException {
    return write(symbols.pair(band, 0), 2);
  }

  @Override
  public int signed(int band) throws IOException {
    return write(symbols.signed(band, 0), 2);
  }

  @Override
  public int wide(int band) throws IOException {
    return write(symbols.signed(band, 0), 4);
  }

  @Override
  public String reference(int band, int tag) throws IOException {
    return place(constants.any(band, tag, Constant.NONE), 2);
  }

  @Override
  public void member(int band, int tag) throws IOException {
    for (Constant part : constants.own(band, tag, Constant.NONE).parts()) {
      place(part, 2);
    }
  }

  @Override
  public void loadable(int band, int bytes) throws IOException {
    int tag = symbols.symbol(BandNumbers.LOADABLE_KIND, 0);
    if (tag > Constant.LAST_TAG || Constant.isMember(tag)) {
      throw new IOException("the packed classes load a constant of kind " + tag);
    }
    place(constants.any(band + 3 * tag, tag, Constant.NONE), bytes);
  }

  private String place(Constant constant, int bytes) {
    if (constant.tag() != 0) {
      places.add(new Place(at, bytes, constant));
    }
    write(0, bytes);
    return constant.text();
  }

  @Override
  public void align(int start) {
    while ((at - start) % 4 != 0) {
      write(0, 1);
    }
  }

  @Override
  public int position() {
    return at;
  }

  @Override
  public int beginLength() {
    write(0, 4);
    return at;
  }

  @Override
  public boolean codeEnds() throws IOException {
    return symbols.symbol(BandNumbers.CODE_END, 0) == 1;
  }

  @Override
  public void endLength(int begin) {
    int end = at;
    at = begin - 4;
    write(end - begin, 4);
    at = end;
  }
}
