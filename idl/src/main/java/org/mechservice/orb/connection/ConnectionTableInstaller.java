package org.mechservice.orb.connection;

import org.jacorb.config.ConfigurationException;
import org.jacorb.orb.ORB;
import org.jacorb.orb.giop.ClientConnectionManager;
import org.jacorb.orb.giop.GIOPConnectionManager;
import org.jacorb.orb.portableInterceptor.ORBInitInfoImpl;
import org.omg.CORBA.INITIALIZE;
import org.omg.CORBA.LocalObject;
import org.omg.PortableInterceptor.ORBInitInfo;
import org.omg.PortableInterceptor.ORBInitializer;

/**
 * Gives an ORB its {@link ConnectionTable}, before anything uses the one it made itself; it has no
 * setting for that.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class ConnectionTableInstaller extends LocalObject implements ORBInitializer {
  private static final long serialVersionUID = 1L;

  private static final OrbField<GIOPConnectionManager> OPENED =
      new OrbField<>(ORB.class, "giop_connection_manager", GIOPConnectionManager.class);
  private static final OrbField<ClientConnectionManager> TABLE =
      new OrbField<>(ORB.class, "clientConnectionManager", ClientConnectionManager.class);

  @Override
  public void pre_init(ORBInitInfo info) {
    ORB orb = ((ORBInitInfoImpl) info).getORB();
    try {
      TABLE.set(orb, new ConnectionTable(orb, OPENED.get(orb), orb.getConfiguration()));
    } catch (ConfigurationException e) {
      throw (INITIALIZE) new INITIALIZE("connections").initCause(e);
    }
  }

  @Override
  public void post_init(ORBInitInfo info) {
    // All is done before.
  }
}
