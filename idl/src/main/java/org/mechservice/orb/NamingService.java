package org.mechservice.orb;

import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.ORB;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.UserException;
import org.omg.CosNaming.NamingContextExt;
import org.omg.CosNaming.NamingContextExtHelper;

/** A CORBA naming service, which knows servers by name. */
final class NamingService {
  private final String address;
  private final NamingContextExt root;

  private NamingService(String address, NamingContextExt root) {
    this.address = address;
    this.root = root;
  }

  /** Returns the naming service at an address, without connecting to it yet. */
  static NamingService at(ORB orb, String host, int port) {
    String address = host + ":" + port;
    return new NamingService(
        address,
        NamingContextExtHelper.unchecked_narrow(
            CallTimeouts.inTime(
                orb, orb.string_to_object("corbaloc:iiop:1.2@" + address + "/NameService"))));
  }

  /**
   * Returns the reference that has a name.
   *
   * @throws ServiceUnreachableException with code S-020 if there is none
   */
  org.omg.CORBA.Object resolve(String name) {
    try {
      return root.resolve_str(name);
    } catch (UserException e) {
      throw unusable("it knows no \"" + name + "\"", e);
    } catch (SystemException e) {
      throw unusable("it does not answer", e);
    }
  }

  /**
   * Gives a reference a name, in place of an earlier one.
   *
   * @throws ServiceUnreachableException with code S-020 if that is not possible
   */
  void bind(String name, org.omg.CORBA.Object reference) {
    try {
      root.rebind(root.to_name(name), reference);
    } catch (UserException e) {
      throw unusable("\"" + name + "\" cannot be bound: " + e.getClass().getSimpleName(), e);
    } catch (SystemException e) {
      throw unusable("it does not answer", e);
    }
  }

  /**
   * Takes a name away.
   *
   * @throws ServiceUnreachableException with code S-020 if that is not possible
   */
  void unbind(String name) {
    try {
      root.unbind(root.to_name(name));
    } catch (UserException e) {
      throw unusable("\"" + name + "\" cannot be unbound", e);
    } catch (SystemException e) {
      throw unusable("it does not answer", e);
    }
  }

  private ServiceUnreachableException unusable(String why, Exception cause) {
    return new ServiceUnreachableException(
        MessageCode.NAMING_SERVICE + " the naming service at " + address + ": " + why, cause);
  }
}
