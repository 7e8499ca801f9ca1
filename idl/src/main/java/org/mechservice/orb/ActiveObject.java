package org.mechservice.orb;

import org.omg.PortableServer.POA;
import org.omg.PortableServer.POAPackage.ObjectNotActive;
import org.omg.PortableServer.POAPackage.WrongPolicy;

/** An object that can be called until it is closed; later calls get {@code OBJECT_NOT_EXIST}. */
public final class ActiveObject implements AutoCloseable {
  private final org.omg.CORBA.Object reference;
  private final POA adapter;
  private final byte[] id;

  ActiveObject(org.omg.CORBA.Object reference, POA adapter, byte[] id) {
    this.reference = reference;
    this.adapter = adapter;
    this.id = id;
  }

  /** Returns the reference to hand out. */
  public org.omg.CORBA.Object reference() {
    return reference;
  }

  /** Ends the object; a call in progress is answered. Idempotent. */
  @Override
  public void close() {
    try {
      adapter.deactivate_object(id);
    } catch (ObjectNotActive e) {
      return; // closed before
    } catch (WrongPolicy e) {
      throw new IllegalStateException(e);
    } catch (org.omg.CORBA.OBJECT_NOT_EXIST | org.omg.CORBA.BAD_INV_ORDER e) {
      return; // the ORB was shut down, and with it the object
    }
  }
}
