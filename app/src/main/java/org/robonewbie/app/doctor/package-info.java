/**
 * The checks of the installation. Start in {@link org.robonewbie.app.doctor.Checkup}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.doctor;
