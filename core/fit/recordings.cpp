#include "core/fit/recordings.hpp"

namespace analogon {

const std::vector<Recording>& Recordings::all() const {
    static const std::vector<Recording> none;
    return all_ ? *all_ : none;
}

std::vector<Recording>& Recordings::edit() {
    if (!all_) {
        all_ = std::make_shared<std::vector<Recording>>();
    } else if (all_.use_count() > 1) {
        all_ = std::make_shared<std::vector<Recording>>(*all_);
    } else {
        std::atomic_thread_fence(std::memory_order_acquire);  // who held it last may have been another thread
    }
    return *all_;
}

}  // namespace analogon
