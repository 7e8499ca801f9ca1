@NullMarked
package org.mechservice.sim.service;

import org.jspecify.annotations.NullMarked;
