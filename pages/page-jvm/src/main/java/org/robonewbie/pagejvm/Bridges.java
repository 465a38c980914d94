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
 * Adapters that let compiled code call a student's object through an interface such as {@code Comparator}.
 */
final class Bridges {

    /** Calls an interface method on the student's object by name. */
    private interface Call {
        @Nullable
        Object of(String method, @Nullable Object... arguments);
    }

    private static final Map<Class<?>, Function<Call, Object>> MAKERS = new HashMap<>();

    static {
        MAKERS.put(Runnable.class, call -> (Runnable) () -> call.of("run"));
        MAKERS.put(Callable.class, call -> (Callable<Object>) () -> call.of("call"));
        MAKERS.put(Comparator.class, call -> (Comparator<Object>) (a, b) -> toInt(call.of("compare", a, b)));
        MAKERS.put(Supplier.class, call -> (Supplier<Object>) () -> call.of("get"));
        MAKERS.put(Consumer.class, call -> (Consumer<Object>) a -> call.of("accept", a));
        MAKERS.put(BiConsumer.class, call -> (BiConsumer<Object, Object>) (a, b) -> call.of("accept", a, b));
        MAKERS.put(Function.class, call -> (Function<Object, Object>) a -> call.of("apply", a));
        MAKERS.put(BiFunction.class, call -> (BiFunction<Object, Object, Object>) (a, b) -> call.of("apply", a, b));
        MAKERS.put(UnaryOperator.class, call -> (UnaryOperator<Object>) a -> call.of("apply", a));
        MAKERS.put(BinaryOperator.class, call -> (BinaryOperator<Object>) (a, b) -> call.of("apply", a, b));
        MAKERS.put(Predicate.class, call -> (Predicate<Object>) a -> toBoolean(call.of("test", a)));
        MAKERS.put(BiPredicate.class, call -> (BiPredicate<Object, Object>) (a, b) -> toBoolean(call.of("test", a, b)));
        MAKERS.put(BooleanSupplier.class, call -> (BooleanSupplier) () -> toBoolean(call.of("getAsBoolean")));
        MAKERS.put(ToIntFunction.class, call -> (ToIntFunction<Object>) a -> toInt(call.of("applyAsInt", a)));
        MAKERS.put(ToLongFunction.class, call ->
                (ToLongFunction<Object>) a -> (Long) nonNull(call.of("applyAsLong", a)));
        MAKERS.put(
                ToDoubleFunction.class, call -> (ToDoubleFunction<Object>) a -> toDouble(call.of("applyAsDouble", a)));
        MAKERS.put(ToDoubleBiFunction.class, call ->
                (ToDoubleBiFunction<Object, Object>) (a, b) -> toDouble(call.of("applyAsDouble", a, b)));
        MAKERS.put(IntSupplier.class, call -> (IntSupplier) () -> toInt(call.of("getAsInt")));
        MAKERS.put(IntConsumer.class, call -> (IntConsumer) a -> call.of("accept", a));
        MAKERS.put(IntFunction.class, call -> (IntFunction<Object>) a -> call.of("apply", a));
        MAKERS.put(IntPredicate.class, call -> (IntPredicate) a -> toBoolean(call.of("test", a)));
        MAKERS.put(IntUnaryOperator.class, call -> (IntUnaryOperator) a -> toInt(call.of("applyAsInt", a)));
        MAKERS.put(IntBinaryOperator.class, call -> (IntBinaryOperator) (a, b) -> toInt(call.of("applyAsInt", a, b)));
        MAKERS.put(IntToDoubleFunction.class, call -> (IntToDoubleFunction) a -> toDouble(call.of("applyAsDouble", a)));
        MAKERS.put(DoubleSupplier.class, call -> (DoubleSupplier) () -> toDouble(call.of("getAsDouble")));
        MAKERS.put(DoubleConsumer.class, call -> (DoubleConsumer) a -> call.of("accept", a));
        MAKERS.put(DoubleFunction.class, call -> (DoubleFunction<Object>) a -> call.of("apply", a));
        MAKERS.put(DoublePredicate.class, call -> (DoublePredicate) a -> toBoolean(call.of("test", a)));
        MAKERS.put(DoubleUnaryOperator.class, call -> (DoubleUnaryOperator) a -> toDouble(call.of("applyAsDouble", a)));
        MAKERS.put(DoubleBinaryOperator.class, call ->
                (DoubleBinaryOperator) (a, b) -> toDouble(call.of("applyAsDouble", a, b)));
        MAKERS.put(Iterable.class, call -> (Iterable<Object>) () -> iterator(nonNull(call.of("iterator"))));
        MAKERS.put(Interpolation.class, call ->
                (Interpolation) (section, joint, fraction) -> toDouble(call.of("degrees", section, joint, fraction)));
        MAKERS.put(Iterator.class, OwnIterator::new);
    }

    private Bridges() {}

    /**
     * Adapts an argument.
     *
     * @param value the student's value
     * @param type the parameter type
     * @param machine executes the calls
     * @return the value, or an adapter for it
     */
    static @Nullable Object adapted(@Nullable Object value, Class<?> type, Machine machine) {
        boolean isOurs = value instanceof StudentObject || value instanceof Lambda;
        if (value == null || !isOurs || type.isInstance(value)) {
            return value;
        }
        Function<Call, Object> maker = MAKERS.get(type);
        if (maker == null) {
            throw new Missing("An object of the program cannot be passed to Java classes as a " + type.getName());
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

    private static Object nonNull(@Nullable Object value) {
        return Objects.requireNonNull(value);
    }

    private static int toInt(@Nullable Object value) {
        return (Integer) nonNull(value);
    }

    private static double toDouble(@Nullable Object value) {
        return (Double) nonNull(value);
    }

    private static boolean toBoolean(@Nullable Object value) {
        return value instanceof Boolean known ? known : toInt(value) != 0;
    }

    @SuppressWarnings("unchecked")
    private static Iterator<Object> iterator(Object iterator) {
        if (iterator instanceof StudentObject own) {
            return new OwnIterator((method, arguments) -> call(own, method, arguments, own.machine()));
        }
        return (Iterator<Object>) iterator;
    }

    /** Adapter for a student's iterator. */
    private record OwnIterator(Call call) implements Iterator<Object> {

        @Override
        public boolean hasNext() {
            return toBoolean(call.of("hasNext"));
        }

        @Override
        public Object next() {
            return nonNull(call.of("next"));
        }
    }
}
