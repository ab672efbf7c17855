/// @file
/// @brief Marks what must outlive the result of a function, so that a compiler can warn.
#pragma once

/// @brief Behind a parameter, or behind a member function for its object: it must outlive the
/// result.
///
/// Clang then warns (-Wdangling, -Wreturn-stack-address) where a view outlives what it refers to.
/// Other compilers see nothing.
#if defined(__clang__) && defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::lifetimebound)
#define BEESPACE_LIFETIMEBOUND [[clang::lifetimebound]]
#endif
#endif
#if !defined(BEESPACE_LIFETIMEBOUND)
#define BEESPACE_LIFETIMEBOUND
#endif
