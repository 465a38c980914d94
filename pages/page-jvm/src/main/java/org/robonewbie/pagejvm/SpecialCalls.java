package org.robonewbie.pagejvm;

import org.jspecify.annotations.Nullable;

/** Methods of compiled classes that the page carries out in another way, such as those that wait. */
public interface SpecialCalls {

    /** The answer for a method that is called as it is. */
    Object UNKNOWN = new Object();

    /** All calls as they are. */
    SpecialCalls NONE = (owner, name, target, arguments) -> UNKNOWN;

    /**
     * Carries out a call.
     *
     * @param owner the class that the program names, with slashes
     * @param name of the method
     * @param target the object; null for a static method
     * @param arguments the arguments
     * @return the result, a {@link Waiting} for one that comes later, or {@link #UNKNOWN}
     */
    @Nullable
    Object call(String owner, String name, @Nullable Object target, @Nullable Object[] arguments);
}
