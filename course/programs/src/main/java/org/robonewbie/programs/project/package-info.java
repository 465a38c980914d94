/**
 * Generation of students' projects by {@link org.robonewbie.programs.project.NewProject}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.project;
