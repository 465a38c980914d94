package org.robonewbie.pagejvm;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.pagejvm.ClassFile.Bootstrap;
import org.robonewbie.pagejvm.ClassFile.Field;
import org.robonewbie.pagejvm.ClassFile.Guard;
import org.robonewbie.pagejvm.ClassFile.MethodCode;
import org.robonewbie.pagejvm.ClassFile.TypeName;

/** Parser of class files. */
final class ClassFileReader {

    private static final int MAGIC = 0xCAFEBABE;
    private static final int NEWEST_VERSION = 61;

    private final DataInputStream input;
    private ConstantReader constants = ConstantReader.NONE;
    private final List<Bootstrap> bootstraps = new ArrayList<>();
    private String source = "Unknown Source";

    private ClassFileReader(byte[] bytes) {
        input = new DataInputStream(new ByteArrayInputStream(bytes));
    }

    /**
     * Parses a class file.
     *
     * @param bytes contents of the file
     * @return the parsed class
     * @throws IllegalArgumentException if it is malformed or newer than Java 17; the message is shown to the user
     */
    static ClassFile read(byte[] bytes) {
        try {
            return new ClassFileReader(bytes).read();
        } catch (IOException | IndexOutOfBoundsException damaged) {
            throw new IllegalArgumentException("This is a damaged class file. Compile the program again.", damaged);
        }
    }

    private ClassFile read() throws IOException {
        if (input.readInt() != MAGIC) {
            throw new IllegalArgumentException(
                    "This is not a class file. Choose a file that javac produced, such as MyAgent.class.");
        }
        input.readUnsignedShort();
        int version = input.readUnsignedShort();
        if (version > NEWEST_VERSION) {
            throw new IllegalArgumentException(
                    "This class file has version " + version
                            + ": it was compiled for a newer version of Java. Recompile the source with \"javac --release 17\".");
        }
        constants = ConstantReader.read(input);
        int access = input.readUnsignedShort();
        String name = className();
        String superName = className();
        List<String> interfaces = new ArrayList<>();
        for (int i = input.readUnsignedShort(); i > 0; i--) {
            interfaces.add(className());
        }
        List<Field> fields = fields();
        List<Unnamed> methods = methods();
        readClassAttributes();
        return new ClassFile(
                name,
                superName,
                List.copyOf(interfaces),
                access,
                constants.all(),
                fields,
                methods.stream().map(method -> method.in(source)).toList(),
                List.copyOf(bootstraps));
    }

    private String className() throws IOException {
        int index = input.readUnsignedShort();
        return index == 0 ? "" : ((TypeName) constants.get(index)).name();
    }

    private String text() throws IOException {
        return constants.text(input.readUnsignedShort());
    }

    private List<Field> fields() throws IOException {
        List<Field> fields = new ArrayList<>();
        for (int i = input.readUnsignedShort(); i > 0; i--) {
            int access = input.readUnsignedShort();
            String name = text();
            String descriptor = text();
            Optional<Object> constant = Optional.empty();
            for (Map.Entry<String, DataInputStream> attribute : attributes()) {
                if (attribute.getKey().equals("ConstantValue")) {
                    constant = Optional.of(constants.get(attribute.getValue().readUnsignedShort()));
                }
            }
            fields.add(new Field(name, descriptor, (access & ClassFile.STATIC) != 0, constant));
        }
        return List.copyOf(fields);
    }

    private List<Unnamed> methods() throws IOException {
        List<Unnamed> methods = new ArrayList<>();
        for (int i = input.readUnsignedShort(); i > 0; i--) {
            int access = input.readUnsignedShort();
            String name = text();
            String descriptor = text();
            MethodCode method = new MethodCode(name, descriptor, access, new byte[0], 0, 0, List.of(), Map.of(), "");
            for (Map.Entry<String, DataInputStream> attribute : attributes()) {
                if (attribute.getKey().equals("Code")) {
                    method = code(method, attribute.getValue());
                }
            }
            methods.add(new Unnamed(method));
        }
        return methods;
    }

    private MethodCode code(MethodCode method, DataInputStream body) throws IOException {
        int stack = body.readUnsignedShort();
        int locals = body.readUnsignedShort();
        byte[] code = new byte[body.readInt()];
        body.readFully(code);
        List<Guard> guards = new ArrayList<>();
        for (int i = body.readUnsignedShort(); i > 0; i--) {
            int from = body.readUnsignedShort();
            int to = body.readUnsignedShort();
            int handler = body.readUnsignedShort();
            int type = body.readUnsignedShort();
            guards.add(new Guard(from, to, handler, type == 0 ? "" : ((TypeName) constants.get(type)).name()));
        }
        Map<Integer, Integer> lines = new LinkedHashMap<>();
        for (Map.Entry<String, DataInputStream> attribute : attributes(body)) {
            if (attribute.getKey().equals("LineNumberTable")) {
                readLines(attribute.getValue(), lines);
            }
        }
        return new MethodCode(
                method.name(), method.descriptor(), method.access(), code, locals, stack, guards, lines, "");
    }

    private static void readLines(DataInputStream table, Map<Integer, Integer> lines) throws IOException {
        for (int i = table.readUnsignedShort(); i > 0; i--) {
            lines.put(table.readUnsignedShort(), table.readUnsignedShort());
        }
    }

    private void readClassAttributes() throws IOException {
        for (Map.Entry<String, DataInputStream> attribute : attributes()) {
            if (attribute.getKey().equals("SourceFile")) {
                source = constants.text(attribute.getValue().readUnsignedShort());
            } else if (attribute.getKey().equals("BootstrapMethods")) {
                readBootstraps(attribute.getValue());
            }
        }
    }

    private void readBootstraps(DataInputStream table) throws IOException {
        for (int i = table.readUnsignedShort(); i > 0; i--) {
            ClassFile.Handle handle = (ClassFile.Handle) constants.get(table.readUnsignedShort());
            List<Object> arguments = new ArrayList<>();
            for (int j = table.readUnsignedShort(); j > 0; j--) {
                arguments.add(constants.get(table.readUnsignedShort()));
            }
            bootstraps.add(new Bootstrap(handle, List.copyOf(arguments)));
        }
    }

    private List<Map.Entry<String, DataInputStream>> attributes() throws IOException {
        return attributes(input);
    }

    private List<Map.Entry<String, DataInputStream>> attributes(DataInputStream from) throws IOException {
        List<Map.Entry<String, DataInputStream>> attributes = new ArrayList<>();
        for (int i = from.readUnsignedShort(); i > 0; i--) {
            String name = constants.text(from.readUnsignedShort());
            byte[] content = new byte[from.readInt()];
            from.readFully(content);
            attributes.add(Map.entry(name, new DataInputStream(new ByteArrayInputStream(content))));
        }
        return attributes;
    }

    /** A method without the source file name, which is not read until the end of the class file. */
    private record Unnamed(MethodCode method) {

        MethodCode in(String source) {
            return new MethodCode(
                    method.name(),
                    method.descriptor(),
                    method.access(),
                    method.code(),
                    method.locals(),
                    method.stack(),
                    method.guards(),
                    method.lines(),
                    source);
        }
    }
}
