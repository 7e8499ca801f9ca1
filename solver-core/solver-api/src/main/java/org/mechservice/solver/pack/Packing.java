package org.mechservice.solver.pack;

import java.io.IOException;
import java.util.List;

/** Carries a class file into symbols. */
final class Packing implements Transfer {
  private static final int BYTE = 0xff;

  private final byte[] file;
  private final ConstantPool pool;
  private final Symbols symbols;
  private final Constants constants;
  private int at;

  /** Where the stretch ends whose length was read last. */
  private int end;

  Packing(byte[] file, Symbols symbols, Constants constants) {
    this.file = file;
    this.pool = ConstantPool.of(file);
    this.symbols = symbols;
    this.constants = constants;
    this.at = pool.end();
  }

  private int read(int bytes) {
    int value = 0;
    for (int i = 0; i < bytes; i++) {
      value = (value << Byte.SIZE) | (file[at++] & BYTE);
    }
    return value;
  }

  @Override
  public int byteOf(int band) throws IOException {
    return symbols.symbol(band, read(1));
  }

  @Override
  public int small(int band) throws IOException {
    return symbols.small(band, read(2));
  }

  @Override
  public int pair(int band) throws IOException {
    return symbols.pair(band, read(2));
  }

  @Override
  public int signed(int band) throws IOException {
    return symbols.signed(band, (short) read(2));
  }

  @Override
  public int wide(int band) throws IOException {
    return symbols.signed(band, read(4));
  }

  @Override
  public String reference(int band, int tag) throws IOException {
    int index = read(2);
    return constants.any(band, tag, index == 0 ? Constant.NONE : pool.at(index)).text();
  }

  @Override
  public void member(int band, int tag) throws IOException {
    List<Constant> nameAndType = List.of(pool.at(read(2)), pool.at(read(2)));
    constants.own(band, tag, new Constant(Constant.NAME_AND_TYPE, "", 0, nameAndType));
  }

  @Override
  public void loadable(int band, int bytes) throws IOException {
    Constant constant = pool.at(read(bytes));
    symbols.symbol(BandNumbers.LOADABLE_KIND, constant.tag());
    constants.any(band + 3 * constant.tag(), constant.tag(), constant);
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
    int length = read(4);
    end = at + length;
    return at;
  }

  @Override
  public boolean codeEnds() throws IOException {
    return symbols.symbol(BandNumbers.CODE_END, at == end ? 1 : 0) == 1;
  }

  @Override
  public void endLength(int begin) {
    // The length follows from what was carried.
  }
}
