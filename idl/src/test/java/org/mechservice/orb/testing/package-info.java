/** Fixtures of the tests of all modules that use the CORBA contract. */
@NullMarked
package org.mechservice.orb.testing;

import org.jspecify.annotations.NullMarked;
