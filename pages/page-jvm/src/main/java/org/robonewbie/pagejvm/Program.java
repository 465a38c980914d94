package org.robonewbie.pagejvm;

import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The classes of a student's program. */
public final class Program {

    private static final String MAIN = "main([Ljava/lang/String;)V";

    private final Map<String, StudentClass> classes = new LinkedHashMap<>();
    private final Compiled compiled = new Compiled();

    /**
     * Loads a program.
     *
     * @param classFiles contents of the class files
     * @throws IllegalArgumentException if a class is malformed or extends one that the page does not support; the message is shown to the
     *     user
     */
    public Program(Collection<byte[]> classFiles) {
        for (byte[] bytes : classFiles) {
            ClassFile file = ClassFileReader.read(bytes);
            classes.put(file.name(), new StudentClass(file, this));
        }
        classes.values().forEach(StudentObjects::check);
    }

    Compiled compiled() {
        return compiled;
    }

    /** {@return the student's class with the given internal name} */
    Optional<StudentClass> find(String name) {
        return Optional.ofNullable(classes.get(name));
    }

    /** {@return the internal names of the classes with a main method} */
    public List<String> mainClasses() {
        return classes.values().stream()
                .filter(type -> type.own(MAIN).isPresent())
                .map(type -> type.file().name())
                .toList();
    }

    /** {@return the internal names of the agent classes that have a no-arg constructor; inner classes last} */
    public List<String> agents() {
        return classes.values().stream()
                .filter(type -> type.is("org/robonewbie/agent/Agent")
                        && type.own("<init>()V").isPresent())
                .map(type -> type.file().name())
                .sorted(Comparator.comparing(name -> name.contains("$")))
                .toList();
    }

    /** {@return the Java names of classes and methods that the program uses but the page does not provide} */
    public List<String> missing() {
        return classes.values().stream()
                .flatMap(type -> type.file().constants().stream())
                .filter(constant -> constant instanceof ClassFile.Member)
                .map(constant -> (ClassFile.Member) constant)
                .filter(member ->
                        !member.owner().startsWith("[") && find(member.owner()).isEmpty())
                .filter(member -> !member.owner().startsWith("java/lang/invoke/")
                        && !member.owner().equals("java/lang/runtime/ObjectMethods"))
                .filter(member -> !compiled.has(member))
                .map(member -> member.owner().replace('/', '.').replace('$', '.')
                        + (compiled.isKnown(member.owner()) ? "." + member.name() : ""))
                .distinct()
                .toList();
    }

    StudentMethod main(String type) {
        return find(type)
                .flatMap(home -> home.own(MAIN))
                .orElseThrow(() -> new IllegalArgumentException(
                        "The class " + type + " has no main method: add public static void main(String[] args)."));
    }
}
