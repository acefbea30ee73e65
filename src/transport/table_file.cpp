#include "transport/table_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cerrno>
#include <cfloat>
#include <cstring>
#include <fstream>

#include "core/files.h"

namespace airlight {

namespace {

static_assert(std::endian::native == std::endian::little, "table files are little-endian, and written from memory as it is");
static_assert(sizeof(f32::Spectrum) == 64 && sizeof(f32::RadianceSpectrum) == 64 && sizeof(f32::IrradianceSpectrum) == 64);

constexpr char magic[8] = {'A', 'I', 'R', 'T', 'A', 'B', 'L', '\n'};
constexpr std::uint32_t max_wavelengths = 4096;
constexpr std::uint64_t alignment = 4096;  // of sections in the file, so that a page of memory can be mapped on each
constexpr std::string_view remedy = "Delete it, or let `airlight bake` write it again.";

enum class Content : std::uint32_t { tables = 1, state = 2 };

// The file's first bytes.
struct Head {
    char magic[8];
    std::uint32_t version;
    Content content;
    std::uint64_t file_bytes;
    std::uint64_t key_high;
    std::uint64_t key_low;
    std::uint32_t wavelengths;  // doubles, in nm, that follow the head
    std::uint32_t sections;     // entries that follow the wavelengths
    std::uint32_t orders_done;
    std::uint32_t unused;
    std::uint64_t checksum;  // of head, wavelengths and entries, this field taken as 0
    char name[64];           // of the atmosphere, UTF-8, filled up with zeros
};
static_assert(sizeof(Head) == 128);

// One table of the file.
struct Entry {
    char name[16];          // filled up with zeros
    std::uint32_t size[4];  // texels, the first running fastest; 1 where there is no such dimension
    std::uint32_t pack;     // which sixteen of the wavelengths, counted from 0
    std::uint32_t unused;
    std::uint64_t offset;  // in the file
    std::uint64_t bytes;
    std::uint64_t checksum;  // of the bytes
};
static_assert(sizeof(Entry) == 64);

// A table in memory that a section of the file holds.
template <class Byte>
struct Section {
    std::string_view name;
    std::array<std::uint32_t, 4> size;
    std::uint32_t pack;
    std::span<Byte> bytes;
};
using SectionToWrite = Section<const std::byte>;
using SectionToRead = Section<std::byte>;

template <class Byte, class TableType>
Section<Byte> section(std::string_view name, std::size_t pack, TableType& table) {
    Section<Byte> made{name, {1, 1, 1, 1}, static_cast<std::uint32_t>(pack), {}};
    std::copy(table.size().begin(), table.size().end(), made.size.begin());
    if constexpr (std::is_const_v<Byte>) made.bytes = std::as_bytes(table.cells());
    else made.bytes = std::as_writable_bytes(table.cells());
    return made;
}

template <class Byte, class Packs>
std::vector<Section<Byte>> sections_of_tables(Packs& packs) {
    std::vector<Section<Byte>> sections;
    for (std::size_t i = 0; i < packs.size(); ++i) {
        sections.push_back(section<Byte>("transmittance", i, packs[i].transmittance));
        sections.push_back(section<Byte>("source", i, packs[i].source));
        sections.push_back(section<Byte>("irradiance", i, packs[i].irradiance));
    }
    return sections;
}

template <class Byte, class State>
std::vector<Section<Byte>> sections_of_state(State& state) {
    return {section<Byte>("source", 0, state.source), section<Byte>("irradiance", 0, state.irradiance),
            section<Byte>("source_sum", 0, state.source_sum), section<Byte>("irradiance_sum", 0, state.irradiance_sum)};
}

std::uint64_t aligned(std::uint64_t offset) { return (offset + alignment - 1) / alignment * alignment; }

// All that stands before the sections.
struct Front {
    Head head{};
    std::vector<double> wavelengths_nm;
    std::vector<Entry> entries;

    std::uint64_t bytes() const { return sizeof(Head) + wavelengths_nm.size() * sizeof(double) + entries.size() * sizeof(Entry); }
    std::string text() const {
        std::string text(reinterpret_cast<const char*>(&head), sizeof head);
        text.append(reinterpret_cast<const char*>(wavelengths_nm.data()), wavelengths_nm.size() * sizeof(double));
        return text.append(reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(Entry));
    }
    std::uint64_t checksum() const {
        Front copy = *this;
        copy.head.checksum = 0;
        const std::string text = copy.text();
        return XXH3_64bits(text.data(), text.size());
    }
};

void copy_name(std::string_view name, std::span<char> to) {
    std::size_t count = std::min(name.size(), to.size() - 1);
    while (count < name.size() && count > 0 && (static_cast<unsigned char>(name[count]) & 0xC0) == 0x80) --count;  // a cut UTF-8 letter
    std::copy_n(name.begin(), count, to.begin());
}

// The front of a file with these sections, but for its checksums: what a writer begins with and a reader must find.
template <class Byte>
Front front_of(const TableOrigin& origin, Content content, int orders_done, std::span<const Section<Byte>> sections) {
    Front front;
    std::copy(std::begin(magic), std::end(magic), front.head.magic);
    front.head.version = table_format_version;
    front.head.content = content;
    front.head.key_high = origin.key.high;
    front.head.key_low = origin.key.low;
    front.head.wavelengths = static_cast<std::uint32_t>(origin.wavelengths.size());
    front.head.sections = static_cast<std::uint32_t>(sections.size());
    front.head.orders_done = static_cast<std::uint32_t>(orders_done);
    copy_name(origin.name, front.head.name);
    for (const Wavelength w : origin.wavelengths) front.wavelengths_nm.push_back(w.in(nm));
    front.entries.resize(sections.size());
    std::uint64_t end = front.bytes();
    for (std::size_t i = 0; i < sections.size(); ++i) {
        Entry& entry = front.entries[i];
        copy_name(sections[i].name, entry.name);
        std::copy(sections[i].size.begin(), sections[i].size.end(), entry.size);
        entry.pack = sections[i].pack;
        entry.offset = aligned(end);
        entry.bytes = sections[i].bytes.size();
        end = entry.offset + entry.bytes;
    }
    front.head.file_bytes = end;
    return front;
}

// The first value of a table that no light has.
std::string wrong_value(std::span<const std::byte> bytes) {
    const std::span<const float> values(reinterpret_cast<const float*>(bytes.data()), bytes.size() / sizeof(float));
    bool right = true;
    for (const float x : values) right &= (x >= 0.0f) & (x <= FLT_MAX);
    if (right) return {};
    const auto wrong = std::find_if(values.begin(), values.end(), [](float x) { return !(x >= 0.0f && x <= FLT_MAX); });
    return fmt::format("value {} is {}", wrong - values.begin() + 1, *wrong);
}

Result<Done> write_sections(const std::filesystem::path& path, Front front, std::span<const SectionToWrite> sections) {
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::string wrong = wrong_value(sections[i].bytes);
        if (!wrong.empty())
            return Error{path.string(), fmt::format("is not written: in table {}, {}", sections[i].name, wrong),
                         "This is a fault of the program: please report it."};
        front.entries[i].checksum = XXH3_64bits(sections[i].bytes.data(), sections[i].bytes.size());
    }
    front.head.checksum = front.checksum();

    static constexpr std::byte padding[alignment] = {};
    const std::string text = front.text();
    std::vector<std::span<const std::byte>> pieces = {std::as_bytes(std::span(text))};
    std::uint64_t end = text.size();
    for (std::size_t i = 0; i < sections.size(); ++i) {
        pieces.push_back(std::span(padding).first(front.entries[i].offset - end));
        pieces.push_back(sections[i].bytes);
        end = front.entries[i].offset + front.entries[i].bytes;
    }
    return write_file(path, pieces);
}

// A file of which the front has been read and found whole.
class OpenFile {
public:
    static Result<OpenFile> open(const std::filesystem::path& path) {
        std::error_code failed;
        if (std::filesystem::exists(path, failed) && !std::filesystem::is_regular_file(path, failed))
            return Error{path.string(), "is not a file", "Name a table file."};
        OpenFile file(path);
        if (!file.stream_)
            return Error{path.string(), fmt::format("cannot be read: {}", std::strerror(errno)),
                         "Check the path and that you may read it."};
        file.bytes_ = static_cast<std::uint64_t>(std::filesystem::file_size(path, failed));
        if (failed) return Error{path.string(), fmt::format("cannot be read: {}", failed.message()), ""};
        if (Result<Done> read = file.read_front(); !read) return read.error();
        return file;
    }

    const Front& front() const { return front_; }
    Error damaged(std::string_view how) const { return wrong(fmt::format("is damaged: {}", how)); }
    Error wrong(std::string what) const { return Error{path_.string(), std::move(what), std::string(remedy)}; }

    // Whether the file is one of this origin, with one of these contents.
    Result<Done> belongs_to(const TableOrigin& origin, Content content) const {
        if (front_.head.key_high != origin.key.high || front_.head.key_low != origin.key.low)
            return wrong("belongs to another atmosphere, other wavelengths or other settings of the bake");
        if (front_.head.content != content)
            return wrong(content == Content::tables ? "holds a bake that was not finished, not tables"
                                                    : "holds tables, not a bake that was not finished");
        return Done{};
    }

    // Fills the sections, which have the sizes that the origin asks for.
    Result<Done> read_sections(const TableOrigin& origin, Content content, std::span<const SectionToRead> sections) {
        if (!same_layout(front_of(origin, content, static_cast<int>(front_.head.orders_done), sections)))
            return damaged("its list of sections is not that of its key");
        for (std::size_t i = 0; i < sections.size(); ++i) {
            const Entry& entry = front_.entries[i];
            const std::string name = fmt::format("section {} of pack {}", sections[i].name, entry.pack);
            if (!read(entry.offset, sections[i].bytes.data(), sections[i].bytes.size())) return damaged(name + " cannot be read");
            if (XXH3_64bits(sections[i].bytes.data(), sections[i].bytes.size()) != entry.checksum) return damaged("checksum of " + name);
            const std::string value = wrong_value(sections[i].bytes);
            if (!value.empty()) return damaged(fmt::format("in {}, {}; it must be finite and not below 0", name, value));
        }
        return Done{};
    }

private:
    explicit OpenFile(const std::filesystem::path& path) : path_(path), stream_(path, std::ios::binary) {}

    bool read(std::uint64_t offset, void* to, std::uint64_t count) {
        stream_.seekg(static_cast<std::streamoff>(offset));
        stream_.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
        return static_cast<std::uint64_t>(stream_.gcount()) == count;
    }

    Error truncated(std::uint64_t wanted) const { return wrong(fmt::format("is truncated: {} of {} bytes", bytes_, wanted)); }

    // Counts are bounded before anything is allocated.
    Result<Done> read_front() {
        Head& head = front_.head;
        const auto stem = static_cast<std::size_t>(std::min<std::uint64_t>(bytes_, sizeof head));
        if (!read(0, &head, stem)) return damaged("it cannot be read");
        if (std::memcmp(head.magic, magic, std::min(stem, sizeof magic)) != 0) return wrong("is not a table file of Airlight");
        if (stem < sizeof head)
            return truncated(std::max<std::uint64_t>(sizeof head, stem >= offsetof(Head, key_high) ? head.file_bytes : 0));
        if (head.version != table_format_version)
            return wrong(fmt::format("was written by format version {}, this program reads {}", head.version, table_format_version));
        if (bytes_ < head.file_bytes) return truncated(head.file_bytes);
        if (bytes_ > head.file_bytes) return damaged(fmt::format("it has {} bytes, and its head says {}", bytes_, head.file_bytes));
        if (head.wavelengths == 0 || head.wavelengths > max_wavelengths || head.sections > max_wavelengths)
            return damaged("counts of its head");
        front_.wavelengths_nm.resize(head.wavelengths);
        front_.entries.resize(head.sections);
        if (front_.bytes() > bytes_) return damaged("counts of its head");
        if (!read(sizeof head, front_.wavelengths_nm.data(), front_.wavelengths_nm.size() * sizeof(double)) ||
            !read(sizeof head + front_.wavelengths_nm.size() * sizeof(double), front_.entries.data(),
                  front_.entries.size() * sizeof(Entry)))
            return damaged("its head cannot be read");
        if (front_.checksum() != head.checksum) return damaged("checksum of its head");
        return Done{};
    }

    // Equal but for checksums, and for the name that people gave.
    bool same_layout(Front expected) const {
        expected.head.checksum = front_.head.checksum;
        std::copy(std::begin(front_.head.name), std::end(front_.head.name), expected.head.name);
        if (expected.entries.size() != front_.entries.size()) return false;
        for (std::size_t i = 0; i < expected.entries.size(); ++i) expected.entries[i].checksum = front_.entries[i].checksum;
        return expected.text() == front_.text();
    }

    std::filesystem::path path_;
    std::ifstream stream_;
    std::uint64_t bytes_ = 0;
    Front front_;
};

Table<f32::RadianceSpectrum, 4> source_table(const TableSizes& s) {
    return Table<f32::RadianceSpectrum, 4>({s.sun, s.azimuth, s.view, s.altitude});
}
Table<f32::IrradianceSpectrum, 2> irradiance_table(const TableSizes& s) { return Table<f32::IrradianceSpectrum, 2>({s.sun, s.altitude}); }

}  // namespace

TableOrigin table_origin(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const BakeSettings& settings) {
    const TableKey key = table_key(atmosphere, wavelengths, settings);
    return {key, atmosphere.name, std::move(wavelengths), settings};
}

Result<Done> write_tables(const std::filesystem::path& path, const TableOrigin& origin, std::span<const PackTables> tables) {
    assert(tables.size() == packs(origin.wavelengths).size());
    const std::vector<SectionToWrite> sections = sections_of_tables<const std::byte>(tables);
    return write_sections(path, front_of<const std::byte>(origin, Content::tables, origin.settings.orders, sections), sections);
}

Result<std::vector<PackTables>> read_tables(const std::filesystem::path& path, const TableOrigin& origin) {
    Result<OpenFile> file = OpenFile::open(path);
    if (!file) return file.error();
    if (Result<Done> right = file->belongs_to(origin, Content::tables); !right) return right.error();
    const TableSizes& s = origin.settings.sizes;
    std::vector<PackTables> tables;
    for (std::size_t i = 0; i < packs(origin.wavelengths).size(); ++i)
        tables.push_back({Table<f32::Spectrum, 2>({s.transmittance_mu, s.transmittance_altitude}), source_table(s), irradiance_table(s)});
    if (Result<Done> read = file->read_sections(origin, Content::tables, sections_of_tables<std::byte>(tables)); !read) return read.error();
    return tables;
}

Result<Done> write_bake_state(const std::filesystem::path& path, const TableOrigin& origin, const BakeState& state) {
    assert(origin.wavelengths.size() <= pack_size && state.orders_done >= 1 && state.orders_done < origin.settings.orders);
    const std::vector<SectionToWrite> sections = sections_of_state<const std::byte>(state);
    return write_sections(path, front_of<const std::byte>(origin, Content::state, state.orders_done, sections), sections);
}

Result<BakeState> read_bake_state(const std::filesystem::path& path, const TableOrigin& origin) {
    Result<OpenFile> file = OpenFile::open(path);
    if (!file) return file.error();
    if (Result<Done> right = file->belongs_to(origin, Content::state); !right) return right.error();
    const std::uint32_t orders_done = file->front().head.orders_done;
    if (orders_done < 1 || orders_done >= static_cast<std::uint32_t>(origin.settings.orders))
        return file->damaged(fmt::format("it says that {} of {} orders are done", orders_done, origin.settings.orders));
    const TableSizes& s = origin.settings.sizes;
    BakeState state{static_cast<int>(orders_done), source_table(s), irradiance_table(s), source_table(s), irradiance_table(s)};
    if (Result<Done> read = file->read_sections(origin, Content::state, sections_of_state<std::byte>(state)); !read) return read.error();
    return state;
}

Result<TableFileSummary> read_table_summary(const std::filesystem::path& path) {
    Result<OpenFile> file = OpenFile::open(path);
    if (!file) return file.error();
    const Head& head = file->front().head;
    TableFileSummary summary{.key = {head.key_high, head.key_low},
                             .name = std::string(head.name, strnlen(head.name, sizeof head.name)),
                             .wavelengths = {},
                             .finished = head.content == Content::tables,
                             .orders_done = static_cast<int>(head.orders_done),
                             .bytes = head.file_bytes};
    for (const double w : file->front().wavelengths_nm) summary.wavelengths.push_back(w * nm);
    return summary;
}

}  // namespace airlight
