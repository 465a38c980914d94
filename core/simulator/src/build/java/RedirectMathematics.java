import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;

/**
 * Copies those classes of ode4j that call {@code Math.sin} or similar functions into a folder that comes first on the
 * class path, with these calls redirected to {@code PortableMath}. Everything else in the classes remains unchanged.
 *
 * <p>Only the constant pool of a class file changes (Java Virtual Machine Specification, 4.4): a method reference
 * contains the index of its class, which is replaced by the index of a class appended to the pool.
 *
 * <p>Usage: {@code java -cp ode4j.jar RedirectMathematics.java FOLDER}
 */
final class RedirectMathematics {

    private static final String PORTABLE = "org/robonewbie/nao/math/PortableMath";
    private static final Set<String> PLATFORM = Set.of("java/lang/Math", "java/lang/StrictMath");
    private static final Set<String> FUNCTIONS = Set.of(
            "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "log10", "pow", "hypot", "toRadians",
            "toDegrees", "rint", "round", "IEEEremainder");

    private static final int UTF8 = 1;
    private static final int LONG = 5;
    private static final int DOUBLE = 6;
    private static final int CLASS = 7;
    private static final int STRING = 8;
    private static final int METHOD = 10;
    private static final int METHOD_HANDLE = 15;
    private static final int METHOD_TYPE = 16;
    private static final int MODULE = 19;
    private static final int PACKAGE = 20;

    private static final int MAGIC_AND_VERSION = 8;

    private final byte[] original;
    private final List<byte[]> constants = new ArrayList<>(List.of(new byte[0]));
    private final int end;

    private RedirectMathematics(byte[] original) throws IOException {
        this.original = original;
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(original));
        in.skipBytes(MAGIC_AND_VERSION);
        int count = in.readUnsignedShort();
        while (constants.size() < count) {
            byte[] constant = readConstant(in);
            constants.add(constant);
            if (constant[0] == LONG || constant[0] == DOUBLE) {
                constants.add(new byte[0]);
            }
        }
        this.end = original.length - in.available();
    }

    public static void main(String[] arguments) throws IOException {
        for (String part : System.getProperty("java.class.path").split(File.pathSeparator)) {
            if (Path.of(part).getFileName().toString().endsWith(".jar")) {
                redirect(Path.of(part), Path.of(arguments[0]));
            }
        }
    }

    private static void redirect(Path jar, Path folder) throws IOException {
        try (JarFile file = new JarFile(jar.toFile())) {
            for (JarEntry entry : file.stream().toList()) {
                if (entry.getName().matches("org/ode4j/.*\\.class")) {
                    byte[] original = file.getInputStream(entry).readAllBytes();
                    new RedirectMathematics(original).writeIfChanged(folder.resolve(entry.getName()));
                }
            }
        }
    }

    private void writeIfChanged(Path target) throws IOException {
        if (redirectMethods()) {
            Files.createDirectories(target.getParent());
            Files.write(target, changed());
        }
    }

    private boolean redirectMethods() {
        int portable = constants.size() + 1;
        boolean found = false;
        for (byte[] constant : constants) {
            if (constant.length > 0 && constant[0] == METHOD && isOfPlatform(constant)) {
                ByteBuffer.wrap(constant).putShort(1, (short) portable);
                found = true;
            }
        }
        return found;
    }

    private boolean isOfPlatform(byte[] method) {
        return PLATFORM.contains(text(at(method, 1), 1)) && FUNCTIONS.contains(text(at(method, 3), 1));
    }

    /** Returns the constant whose index is stored at an offset within another constant. */
    private byte[] at(byte[] constant, int offset) {
        return constants.get(Short.toUnsignedInt(ByteBuffer.wrap(constant).getShort(offset)));
    }

    private String text(byte[] constant, int offset) {
        byte[] utf8 = at(constant, offset);
        return new String(utf8, 3, utf8.length - 3, StandardCharsets.UTF_8);
    }

    private byte[] changed() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.write(original, 0, MAGIC_AND_VERSION);
        out.writeShort(constants.size() + 2);
        for (byte[] constant : constants) {
            out.write(constant);
        }
        out.writeByte(UTF8);
        out.writeUTF(PORTABLE);
        out.writeByte(CLASS);
        out.writeShort(constants.size());
        out.write(original, end, original.length - end);
        return bytes.toByteArray();
    }

    private static byte[] readConstant(DataInputStream in) throws IOException {
        in.mark(3);
        int tag = in.readUnsignedByte();
        int length = length(tag, tag == UTF8 ? in.readUnsignedShort() : 0);
        in.reset();
        return in.readNBytes(length);
    }

    private static int length(int tag, int textLength) {
        return switch (tag) {
            case UTF8 -> 3 + textLength;
            case LONG, DOUBLE -> 9;
            case CLASS, STRING, METHOD_TYPE, MODULE, PACKAGE -> 3;
            case METHOD_HANDLE -> 4;
            default -> 5;
        };
    }
}
