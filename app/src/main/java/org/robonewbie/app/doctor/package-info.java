/**
 * Checks of the installation. Start with {@link org.robonewbie.app.doctor.Checkup}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.doctor;
