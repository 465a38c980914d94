package org.robonewbie.pagejvm;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.BiPredicate;
import java.util.function.BinaryOperator;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleFunction;
import java.util.function.DoublePredicate;
import java.util.function.DoubleSupplier;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.function.IntBinaryOperator;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.IntSupplier;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import java.util.function.ToLongFunction;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.motion.Interpolation;

/**
 * What compiled code calls when it has got an object of the student where it wants an interface, such as a comparator: a compiled
 * object that passes calls on.
 */
final class Bridges {

    /** A call of the interface's method. */
    private interface Call {
        @Nullable
        Object of(String method, @Nullable Object... arguments);
    }

    private static final Map<Class<?>, Function<Call, Object>> MAKERS = new HashMap<>();

    static {
        MAKERS.put(Runnable.class, call -> (Runnable) () -> call.of("run"));
        MAKERS.put(Callable.class, call -> (Callable<Object>) () -> call.of("call"));
        MAKERS.put(Comparator.class, call -> (Comparator<Object>) (a, b) -> whole(call.of("compare", a, b)));
        MAKERS.put(Supplier.class, call -> (Supplier<Object>) () -> call.of("get"));
        MAKERS.put(Consumer.class, call -> (Consumer<Object>) a -> call.of("accept", a));
        MAKERS.put(BiConsumer.class, call -> (BiConsumer<Object, Object>) (a, b) -> call.of("accept", a, b));
        MAKERS.put(Function.class, call -> (Function<Object, Object>) a -> call.of("apply", a));
        MAKERS.put(BiFunction.class, call -> (BiFunction<Object, Object, Object>) (a, b) -> call.of("apply", a, b));
        MAKERS.put(UnaryOperator.class, call -> (UnaryOperator<Object>) a -> call.of("apply", a));
        MAKERS.put(BinaryOperator.class, call -> (BinaryOperator<Object>) (a, b) -> call.of("apply", a, b));
        MAKERS.put(Predicate.class, call -> (Predicate<Object>) a -> truth(call.of("test", a)));
        MAKERS.put(BiPredicate.class, call -> (BiPredicate<Object, Object>) (a, b) -> truth(call.of("test", a, b)));
        MAKERS.put(BooleanSupplier.class, call -> (BooleanSupplier) () -> truth(call.of("getAsBoolean")));
        MAKERS.put(ToIntFunction.class, call -> (ToIntFunction<Object>) a -> whole(call.of("applyAsInt", a)));
        MAKERS.put(ToLongFunction.class, call -> (ToLongFunction<Object>) a -> (Long) some(call.of("applyAsLong", a)));
        MAKERS.put(ToDoubleFunction.class, call -> (ToDoubleFunction<Object>) a -> real(call.of("applyAsDouble", a)));
        MAKERS.put(ToDoubleBiFunction.class, call ->
                (ToDoubleBiFunction<Object, Object>) (a, b) -> real(call.of("applyAsDouble", a, b)));
        MAKERS.put(IntSupplier.class, call -> (IntSupplier) () -> whole(call.of("getAsInt")));
        MAKERS.put(IntConsumer.class, call -> (IntConsumer) a -> call.of("accept", a));
        MAKERS.put(IntFunction.class, call -> (IntFunction<Object>) a -> call.of("apply", a));
        MAKERS.put(IntPredicate.class, call -> (IntPredicate) a -> truth(call.of("test", a)));
        MAKERS.put(IntUnaryOperator.class, call -> (IntUnaryOperator) a -> whole(call.of("applyAsInt", a)));
        MAKERS.put(IntBinaryOperator.class, call -> (IntBinaryOperator) (a, b) -> whole(call.of("applyAsInt", a, b)));
        MAKERS.put(IntToDoubleFunction.class, call -> (IntToDoubleFunction) a -> real(call.of("applyAsDouble", a)));
        MAKERS.put(DoubleSupplier.class, call -> (DoubleSupplier) () -> real(call.of("getAsDouble")));
        MAKERS.put(DoubleConsumer.class, call -> (DoubleConsumer) a -> call.of("accept", a));
        MAKERS.put(DoubleFunction.class, call -> (DoubleFunction<Object>) a -> call.of("apply", a));
        MAKERS.put(DoublePredicate.class, call -> (DoublePredicate) a -> truth(call.of("test", a)));
        MAKERS.put(DoubleUnaryOperator.class, call -> (DoubleUnaryOperator) a -> real(call.of("applyAsDouble", a)));
        MAKERS.put(DoubleBinaryOperator.class, call ->
                (DoubleBinaryOperator) (a, b) -> real(call.of("applyAsDouble", a, b)));
        MAKERS.put(Iterable.class, call -> (Iterable<Object>) () -> iterator(some(call.of("iterator"))));
        MAKERS.put(Interpolation.class, call ->
                (Interpolation) (section, joint, fraction) -> real(call.of("degrees", section, joint, fraction)));
        MAKERS.put(Iterator.class, OwnIterator::new);
    }

    private Bridges() {}

    /**
     * Adapts an argument.
     *
     * @param value what the program gives
     * @param type what compiled code wants
     * @param machine carries out calls
     * @return the value, or an object that passes calls on to it
     */
    static @Nullable Object adapted(@Nullable Object value, Class<?> type, Machine machine) {
        boolean isOurs = value instanceof StudentObject || value instanceof Lambda;
        if (value == null || !isOurs || type.isInstance(value)) {
            return value;
        }
        Function<Call, Object> maker = MAKERS.get(type);
        if (maker == null) {
            throw new Missing("An object of the program cannot be a " + type.getName() + " for Java's own classes");
        }
        return maker.apply((method, arguments) -> call(value, method, arguments, machine));
    }

    private static @Nullable Object call(Object value, String method, @Nullable Object[] arguments, Machine machine) {
        if (value instanceof Lambda lambda) {
            return lambda.call(arguments);
        }
        StudentObject object = (StudentObject) value;
        StudentMethod found = object.type()
                .findByName(method, arguments.length)
                .orElseThrow(() -> new Missing(object.type() + " has no method " + method));
        return machine.call(found, Members.with(value, arguments));
    }

    private static Object some(@Nullable Object value) {
        return Objects.requireNonNull(value);
    }

    private static int whole(@Nullable Object value) {
        return (Integer) some(value);
    }

    private static double real(@Nullable Object value) {
        return (Double) some(value);
    }

    private static boolean truth(@Nullable Object value) {
        return value instanceof Boolean known ? known : whole(value) != 0;
    }

    @SuppressWarnings("unchecked")
    private static Iterator<Object> iterator(Object iterator) {
        if (iterator instanceof StudentObject own) {
            return new OwnIterator((method, arguments) -> call(own, method, arguments, own.machine()));
        }
        return (Iterator<Object>) iterator;
    }

    /** An iterator of the student. */
    private record OwnIterator(Call call) implements Iterator<Object> {

        @Override
        public boolean hasNext() {
            return truth(call.of("hasNext"));
        }

        @Override
        public Object next() {
            return some(call.of("next"));
        }
    }
}
