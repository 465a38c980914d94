package org.robonewbie.web.compiling;

import java.lang.reflect.Modifier;
import java.util.Set;
import org.teavm.extension.introspect.IntrospectMember;
import org.teavm.extension.spi.reflection.SimpleReflectionPolicy;

/** TeaVM policy that keeps all members available to students' programs accessible by reflection. */
public final class ProgramsCall extends SimpleReflectionPolicy {

    /** Whether the module without students' programs is being compiled. */
    private static final boolean WITHOUT_PROGRAMS = Boolean.getBoolean("robonewbie.withoutPrograms");

    /**
     * Excluded methods: those that connect to a simulator, which the page replaces, and those that make threads wait for each other.
     */
    private static final Set<String> OTHERWISE =
            Set.of("Nao.connect", "Agent.run", "Agent.runTogether", "Object.wait", "Object.notify", "Object.notifyAll");

    /** The available methods of {@code Class}; TeaVM 0.15.0 translates some of the others incorrectly. */
    private static final Set<String> OF_CLASS =
            Set.of("getName", "getSimpleName", "isInstance", "toString", "desiredAssertionStatus");

    /** Interfaces of Java 21 in TeaVM's library that declare methods of {@code Deque}, {@code List} and similar types. */
    private static final Set<String> SEQUENCED =
            Set.of("java.util.SequencedCollection", "java.util.SequencedSet", "java.util.SequencedMap");

    /** Creates the policy; TeaVM finds it by name. */
    public ProgramsCall() {}

    @Override
    protected void setup() {
        selectClasses(type -> !WITHOUT_PROGRAMS && isOfPrograms(type.name()))
                .foundByName()
                .reflectableMembers(ProgramsCall::isCallable);
    }

    private static boolean isOfPrograms(String name) {
        return ProgramLibrary.has(name) || SEQUENCED.contains(name);
    }

    private static boolean isCallable(IntrospectMember member) {
        boolean isOfClass = member.declaringClass().name().equals("java.lang.Class");
        return PUBLIC.test(member)
                && (!isOfClass || OF_CLASS.contains(member.name()))
                && !Modifier.isNative(member.modifiers())
                && !OTHERWISE.contains(member.declaringClass().simpleName() + "." + member.name());
    }
}
