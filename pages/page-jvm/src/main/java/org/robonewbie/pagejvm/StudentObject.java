package org.robonewbie.pagejvm;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Instance of a student's class. */
interface StudentObject {

    StudentClass type();

    /** {@return the machine that executes its methods} */
    Machine machine();

    /** {@return its fields, by class and name} */
    Map<String, @Nullable Object> fields();

    /**
     * Calls a method of the compiled superclass, as {@code super} does.
     *
     * @param member the method
     * @param arguments its arguments
     * @return its result
     */
    @Nullable
    Object callSuper(ClassFile.Member member, @Nullable Object[] arguments);

    /**
     * Reads a field of the compiled superclass.
     *
     * @param name name of the field
     * @return its value
     */
    default Object inheritedField(String name) {
        throw new Missing(type() + " inherits no field " + name);
    }
}
