/**
 * RCSSServerMJ, the server of the RoboCup 3D league since 2026, as a simulator for agents: found or started, and shown in the studio.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.league;
